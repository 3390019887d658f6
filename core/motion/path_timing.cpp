// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/path_timing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace hexapose {

namespace {

using State = PathTiming::State;

constexpr std::size_t kCapSamples = 256; ///< of the rate limit over s
constexpr int kBrakeSamples = 24;        ///< of a braking, when it is checked
constexpr int kStepsOfAPlan = 1000;      ///< about, where the limits let the plan be as coarse as that
constexpr int kStepsOfAJerk = 10;        ///< at least, in the time that a change of acceleration takes
constexpr int kBisections = 10;          ///< of the jerk
constexpr double kRampsPerPlan = 500;    ///< at most: a ramp is no shorter a part of the plan
constexpr int kMostSteps = 50000;        ///< a guard, never met: a plan ends long before
constexpr double kEndTolerance = 1e-6;   ///< of s: so close to the end of a braking, the braking begins

State after(const State& state, double jerk, double t) {
    return {state.s + t * (state.rate + t * (0.5 * state.acceleration + t * jerk / 6.0)),
            state.rate + t * (state.acceleration + 0.5 * t * jerk), state.acceleration + t * jerk};
}

/// The rate limit over s, read between samples on a straight line.
class RateCap {
public:
    RateCap(double rate, const std::function<double(double)>& largestRate) : m_rate(rate) {
        for (std::size_t k = 0; k <= kCapSamples; ++k)
            m_least[0][k] = std::min(rate, largestRate(static_cast<double>(k) / kCapSamples));
        for (std::size_t level = 1; level < kLevels; ++level)
            for (std::size_t k = 0; k + (std::size_t{1} << level) <= kCapSamples + 1; ++k)
                m_least[level][k] =
                    std::min(m_least[level - 1][k], m_least[level - 1][k + (std::size_t{1} << (level - 1))]);
    }
    double at(double s) const {
        const double place = std::clamp(s, 0.0, 1.0) * kCapSamples;
        const auto low = static_cast<std::size_t>(place);
        const std::size_t high = std::min<std::size_t>(low + 1, kCapSamples);
        return std::lerp(m_least[0][low], m_least[0][high], place - static_cast<double>(low));
    }
    /// The lowest between two places.
    double least(double from, double to) const {
        const auto first = static_cast<std::size_t>(std::clamp(from, 0.0, 1.0) * kCapSamples);
        const auto last = static_cast<std::size_t>(std::ceil(std::clamp(to, 0.0, 1.0) * kCapSamples));
        const std::size_t count = std::max(last, first) - first + 1;
        const auto level = static_cast<std::size_t>(std::bit_width(count)) - 1;
        return std::min(m_least[level][first], m_least[level][first + count - (std::size_t{1} << level)]);
    }
    double least() const { return least(0.0, 1.0); }
    bool limits() const { return least() < m_rate; }
    /// The whole path at these rates, s.
    double seconds() const {
        double sum = 0.0;
        for (std::size_t k = 0; k < kCapSamples; ++k)
            sum += 2.0 / (m_least[0][k] + m_least[0][k + 1]);
        return sum / kCapSamples;
    }

private:
    static constexpr std::size_t kLevels = 9; ///< 2^8 samples, and the last one
    double m_rate;
    /// [level][k]: the lowest of 2^level samples from k on.
    std::array<std::array<double, kCapSamples + 1>, kLevels> m_least;
};

/// A path of many ramps' times needs no ramps as steep as that.
PathBounds withoutShortRamps(PathBounds bounds, double seconds) {
    const double ramp = seconds / kRampsPerPlan;
    bounds.acceleration = std::min(bounds.acceleration, bounds.rate / ramp);
    bounds.jerk = std::min(bounds.jerk, bounds.acceleration / ramp);
    return bounds;
}

bool isPositive(double number) {
    return number > 0.0 && std::isfinite(number);
}

/// Seconds from rest to a rate.
double rampTime(double rate, const PathBounds& bounds) {
    return rate * bounds.jerk >= bounds.acceleration * bounds.acceleration
               ? rate / bounds.acceleration + bounds.acceleration / bounds.jerk
               : 2.0 * std::sqrt(rate / bounds.jerk);
}

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
    const State rest = braking.at(state, duration);
    if (rest.s > 1.0 + 1e-12)
        return false;
    // The rate is largest where the acceleration has just gone.
    const State fastest = braking.at(state, std::max(state.acceleration, 0.0) / bounds.jerk);
    if (fastest.rate <= cap.least(state.s, rest.s))
        return true;
    if (fastest.rate > cap.at(fastest.s) * kRoundOff)
        return false;
    for (int k = 1; k < kBrakeSamples; ++k) {
        const State later = braking.at(state, duration * k / kBrakeSamples);
        if (later.acceleration <= 0.0 && later.rate <= cap.least(later.s, rest.s))
            return true; // it only falls from here on
        if (later.rate > cap.at(later.s) * kRoundOff)
            return false;
    }
    return true;
}

} // namespace

PathTiming::PathTiming(const PathBounds& given, const std::function<double(double)>& largestRate,
                       PlanTimer* timer) {
    const RateCap cap(given.rate, largestRate);
    if (!isPositive(given.rate) || !isPositive(given.acceleration) || !isPositive(given.jerk) ||
        !isPositive(cap.least())) {
        m_duration = std::numeric_limits<double>::infinity();
        return;
    }
    if (!cap.limits()) {
        addProfile(given);
        finish();
        return;
    }
    const PathBounds bounds = withoutShortRamps(given, cap.seconds());
    const double whole =
        cap.seconds() + cap.least() / bounds.acceleration + bounds.acceleration / bounds.jerk;
    const double step = std::min(whole / kStepsOfAPlan, bounds.acceleration / bounds.jerk / kStepsOfAJerk);
    for (int k = 0; k < kMostSteps; ++k) {
        if (timer && timer->expired())
            return;
        const Braking braking(m_end, bounds);
        if (k > 0 && braking.at(m_end, braking.duration()).s >= 1.0 - kEndTolerance)
            break;
        double low = std::max(-bounds.jerk, (-bounds.acceleration - m_end.acceleration) / step);
        double high = std::min(bounds.jerk, (bounds.acceleration - m_end.acceleration) / step);
        if (keepsLimits(after(m_end, high, step), bounds, cap)) {
            low = high;
        } else {
            for (int halving = 0; halving < kBisections; ++halving) {
                const double middle = 0.5 * (low + high);
                (keepsLimits(after(m_end, middle, step), bounds, cap) ? low : high) = middle;
            }
        }
        add(low, step);
    }
    const Braking braking(m_end, bounds);
    for (std::size_t piece = 0; piece < 3; ++piece)
        add(braking.jerks[piece], braking.times[piece]);
    finish();
}

void PathTiming::add(double jerk, double seconds) {
    if (!(seconds > 0.0))
        return;
    m_pieces.push_back({m_duration, m_end, jerk});
    m_end = after(m_end, jerk, seconds);
    m_duration += seconds;
}

/// Constant limits: up to the highest rate from which there is room to brake, and down again.
void PathTiming::addProfile(const PathBounds& bounds) {
    const double a = bounds.acceleration, j = bounds.jerk;
    double rate = bounds.rate;
    if (rate * rampTime(rate, bounds) > 1.0) { // two ramps to it are longer than the path
        rate = std::cbrt(0.25 * j);
        if (rate * j > a * a)
            rate = 0.5 * (std::sqrt(a * a / j * (a * a / j) + 4.0 * a) - a * a / j);
    }
    const double reached = std::min(a, std::sqrt(rate * j));
    const double change = reached / j;
    const double ramp = std::max(rate / reached - change, 0.0);
    const double cruise = std::max(1.0 / rate - rampTime(rate, bounds), 0.0);
    const std::array<std::pair<double, double>, 7> profile{
        {{j, change}, {0.0, ramp}, {-j, change}, {0.0, cruise}, {-j, change}, {0.0, ramp}, {j, change}}};
    for (const auto& [jerk, seconds] : profile)
        add(jerk, seconds);
}

void PathTiming::finish() {
    // What is missing of the whole path, a millionth, is spread over all of it.
    const double stretch = 1.0 / m_end.s;
    for (std::size_t k = 0; k < m_pieces.size(); ++k) {
        Piece& piece = m_pieces[k];
        piece.state.s *= stretch;
        piece.state.rate *= stretch;
        piece.state.acceleration *= stretch;
        piece.jerk *= stretch;
        m_maxRate = std::max(m_maxRate, piece.state.rate);
        m_maxAcceleration = std::max(m_maxAcceleration, std::abs(piece.state.acceleration));
        // Within a piece the rate is highest where the acceleration passes through zero.
        const double top = -piece.state.acceleration / piece.jerk;
        const double end = k + 1 < m_pieces.size() ? m_pieces[k + 1].begin : m_duration;
        if (piece.state.acceleration > 0.0 && top > 0.0 && top < end - piece.begin)
            m_maxRate = std::max(m_maxRate, after(piece.state, piece.jerk, top).rate);
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
    if (next == m_pieces.begin())
        return {};
    const Piece& piece = *(next - 1);
    return after(piece.state, piece.jerk, seconds - piece.begin);
}

} // namespace hexapose
