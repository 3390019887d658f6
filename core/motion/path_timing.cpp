// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/path_timing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hexapose {

namespace {

using State = PathTiming::State;

constexpr int kCapSamples = 256;       ///< of the rate limit over s
constexpr int kBrakeSamples = 24;      ///< of a braking, when it is judged
constexpr int kStepsOfAPlan = 1000;    ///< about, where the limits let the plan be as coarse as that
constexpr int kStepsOfAJerk = 10;      ///< at least, in the time that a change of acceleration takes
constexpr int kBisections = 10;        ///< of the jerk
constexpr int kMostSteps = 200000;     ///< a guard, never met: a plan ends long before
constexpr double kEndTolerance = 1e-6; ///< of s: so close to the end of a braking, the braking begins

State after(const State& state, double jerk, double t) {
    return {state.s + t * (state.rate + t * (0.5 * state.acceleration + t * jerk / 6.0)),
            state.rate + t * (state.acceleration + 0.5 * t * jerk), state.acceleration + t * jerk};
}

/// The rate limit over s, read between samples by the lower neighbour.
class RateCap {
public:
    RateCap(double rate, const std::function<double(double)>& largestRate) {
        for (int k = 0; k <= kCapSamples; ++k)
            m_caps[static_cast<std::size_t>(k)] =
                std::min(rate, largestRate(static_cast<double>(k) / kCapSamples));
    }
    double at(double s) const {
        const double place = std::clamp(s, 0.0, 1.0) * kCapSamples;
        const auto low = static_cast<std::size_t>(place);
        const std::size_t high = std::min<std::size_t>(low + 1, kCapSamples);
        return std::lerp(m_caps[low], m_caps[high], place - static_cast<double>(low));
    }
    double least() const { return *std::min_element(m_caps.begin(), m_caps.end()); }

private:
    std::array<double, kCapSamples + 1> m_caps;
};

/// From a state to rest as soon as jerk and acceleration allow: jerk down, hold, jerk up.
struct Braking {
    std::array<double, 3> times{};
    std::array<double, 3> jerks{};
    bool possible = false; ///< without going backwards

    Braking(const State& state, const PathBounds& bounds) {
        const double J = bounds.jerk;
        const double peakSquared = J * state.rate + 0.5 * state.acceleration * state.acceleration;
        const double peak = std::min(std::sqrt(std::max(peakSquared, 0.0)), bounds.acceleration);
        const double down = (state.acceleration + peak) / J;
        possible = peakSquared >= 0.0 && down >= -1e-12 / J * bounds.acceleration && state.rate >= 0.0;
        const double left = peakSquared / J - peak * peak / J; // rate that is neither on the way down nor up
        times = {std::max(down, 0.0), peak > 0.0 ? std::max(left, 0.0) / peak : 0.0, peak / J};
        jerks = {-J, 0.0, J};
    }
    double duration() const { return times[0] + times[1] + times[2]; }
    State at(State state, double t) const {
        for (std::size_t piece = 0; piece < 3; ++piece) {
            const double part = std::min(t, times[piece]);
            state = after(state, jerks[piece], part);
            t -= part;
        }
        return state;
    }
};

bool keepsLimits(const State& state, const PathBounds& bounds, const RateCap& cap) {
    constexpr double kRoundOff = 1.0 + 1e-9;
    if (std::abs(state.acceleration) > bounds.acceleration * kRoundOff ||
        state.rate > cap.at(state.s) * kRoundOff)
        return false;
    const Braking braking(state, bounds);
    if (!braking.possible)
        return false;
    const double duration = braking.duration();
    if (braking.at(state, duration).s > 1.0 + 1e-12)
        return false;
    // The rate is largest where the acceleration has just gone.
    const double top = std::max(state.acceleration, 0.0) / bounds.jerk;
    const State maxSpeed = braking.at(state, top);
    if (maxSpeed.rate > cap.at(maxSpeed.s) * kRoundOff)
        return false;
    for (int k = 1; k < kBrakeSamples; ++k) {
        const State later = braking.at(state, duration * k / kBrakeSamples);
        if (later.rate > cap.at(later.s) * kRoundOff)
            return false;
    }
    return true;
}

} // namespace

PathTiming::PathTiming(const PathBounds& bounds, const std::function<double(double)>& largestRate,
                       PlanTimer* timer) {
    const RateCap cap(bounds.rate, largestRate);
    const double whole =
        1.0 / cap.least() + cap.least() / bounds.acceleration + bounds.acceleration / bounds.jerk;
    const double step = std::min(whole / kStepsOfAPlan, bounds.acceleration / bounds.jerk / kStepsOfAJerk);
    State state;
    double time = 0.0;
    const auto add = [&](double jerk, double seconds) {
        m_pieces.push_back({time, state, jerk});
        state = after(state, jerk, seconds);
        time += seconds;
    };
    for (int k = 0; k < kMostSteps; ++k) {
        if (timer && timer->expired())
            return;
        const Braking braking(state, bounds);
        if (k > 0 && braking.at(state, braking.duration()).s >= 1.0 - kEndTolerance)
            break;
        double low = -bounds.jerk;
        double high = bounds.jerk;
        if (keepsLimits(after(state, high, step), bounds, cap)) {
            low = high;
        } else {
            for (int halving = 0; halving < kBisections; ++halving) {
                const double middle = 0.5 * (low + high);
                (keepsLimits(after(state, middle, step), bounds, cap) ? low : high) = middle;
            }
        }
        add(low, step);
    }
    const Braking braking(state, bounds);
    for (std::size_t piece = 0; piece < 3; ++piece)
        add(braking.jerks[piece], braking.times[piece]);
    m_duration = time;
    // What is missing of the whole way, a millionth, is spread over all of it.
    const double stretch = 1.0 / state.s;
    for (Piece& piece : m_pieces) {
        piece.state.s *= stretch;
        piece.state.rate *= stretch;
        piece.state.acceleration *= stretch;
        piece.jerk *= stretch;
    }
}

std::optional<PathTiming> PathTiming::plan(const PathBounds& bounds,
                                           const std::function<double(double)>& largestRate,
                                           PlanTimer& timer) {
    PathTiming timing(bounds, largestRate, &timer);
    return timer.expired() ? std::nullopt : std::optional(std::move(timing));
}

PathTiming::State PathTiming::at(double seconds) const {
    if (seconds >= m_duration)
        return {1.0, 0.0, 0.0};
    if (!(seconds > 0.0))
        return {};
    const auto next = std::upper_bound(m_pieces.begin(), m_pieces.end(), seconds,
                                       [](double t, const Piece& piece) { return t < piece.begin; });
    const Piece& piece = *(next - 1);
    return after(piece.state, piece.jerk, seconds - piece.begin);
}

} // namespace hexapose
