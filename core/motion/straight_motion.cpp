// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/straight_motion.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace hexapose {

namespace {

constexpr double kMargin = 0.995;   ///< of a limit that holds along the path: the plan is made of steps
constexpr int kLegSamples = 200;    ///< of the legs' accelerations
constexpr int kReplans = 8;         ///< for them
constexpr double kRounding = 1e-14; ///< of a sum of lengths
constexpr double kNoLength = 1e-12; ///< of the machine's size, and rad

/// A limit of s from a limit of what grows by `length` over the whole path.
double share(double limit, double length) {
    return length > 0.0 ? limit / length : std::numeric_limits<double>::infinity();
}

/// What the legs do along the path: their lengths' derivatives by s, at even steps of s.
class LegSlopes {
public:
    LegSlopes(const PlatformModel& model, const Pose& from, const Twist& displacement) {
        for (std::size_t k = 0; k < m_slopes.size(); ++k) {
            const Pose pose = displaced(from, static_cast<double>(k) / kSlopeSteps * displacement);
            m_slopes[k] = model.jacobian(pose) * displacement;
        }
    }
    LegVector at(double s) const {
        const double place = std::clamp(s, 0.0, 1.0) * kSlopeSteps;
        const std::size_t low = std::min(static_cast<std::size_t>(place), m_slopes.size() - 2);
        return m_slopes[low] + (place - static_cast<double>(low)) * (m_slopes[low + 1] - m_slopes[low]);
    }

private:
    static constexpr int kSlopeSteps = 256;
    std::array<LegVector, kSlopeSteps + 1> m_slopes;
};

/// Largest acceleration of any leg over the motion.
double largestLegAcceleration(const LegSlopes& slopes, const PathTiming& timing, PlanTimer* timer) {
    const double step = timing.duration() / kLegSamples;
    LegVector before = LegVector::Zero();
    double largest = 0.0;
    for (int k = 1; k <= kLegSamples && !(timer && timer->expired()); ++k) {
        const PathTiming::State state = timing.at(k * step);
        const LegVector now = state.rate * slopes.at(state.s);
        largest = std::max(largest, (now - before).cwiseAbs().maxCoeff() / step);
        before = now;
    }
    return largest;
}

} // namespace

StraightMotion::StraightMotion(const PlatformModel& model, const Pose& from, const Pose& to,
                               const MotionBounds& bounds, PlanTimer* timer)
    : m_from(from), m_to(to), m_displacement(displacement(from, to)) {
    const double length = m_displacement.head<3>().norm();
    const double turn = m_displacement.tail<3>().norm();
    if (length <= kNoLength * model.size() && turn <= kNoLength)
        return;
    PathBounds path{std::min(share(bounds.speed, length), share(bounds.angularSpeed, turn)),
                    std::min(share(bounds.acceleration, length), share(bounds.angularAcceleration, turn)),
                    std::min(share(bounds.jerk, length), share(bounds.angularJerk, turn))};
    double legSpeed = kMargin * bounds.legSpeed;
    const LegSlopes slopes(model, from, m_displacement);
    const auto largestRate = [&](double s) { return share(legSpeed, slopes.at(s).cwiseAbs().maxCoeff()); };
    // Where the legs would be accelerated too hard all of the motion is slowed down.
    for (int plan = 0; plan < kReplans; ++plan) {
        if (!timer)
            m_timing.emplace(path, largestRate);
        else if (m_timing = PathTiming::plan(path, largestRate, *timer); !m_timing)
            return;
        const double excess = largestLegAcceleration(slopes, *m_timing, timer) / bounds.legAcceleration;
        if (excess <= 1.0)
            break;
        const double slower = kMargin / std::sqrt(excess);
        path = {path.rate * slower, path.acceleration * slower * slower,
                path.jerk * slower * slower * slower};
        legSpeed *= slower;
    }
}

std::optional<StraightMotion> StraightMotion::plan(const PlatformModel& model, const Pose& from,
                                                   const Pose& to, const MotionBounds& bounds,
                                                   PlanTimer& timer) {
    StraightMotion motion(model, from, to, bounds, &timer);
    return timer.expired() ? std::nullopt : std::optional(std::move(motion));
}

RateBounds StraightMotion::rateBounds(const Eigen::Vector3d& p_PC_P) const {
    if (!m_timing)
        return {};
    const Eigen::Vector3d along = m_displacement.head<3>(), turn = m_displacement.tail<3>();
    const double angle = turn.norm();
    // C goes by along + turned(s) per s: turned(s) rotates about `turn`, so the sum is longest at an end of
    // the path, or where turned(s) points along `along` best.
    const Eigen::Vector3d turned = turn.cross(rotationMatrix(m_from.angles) * p_PC_P);
    double longest = std::max((along + turned).norm(), (along + rotationOf(turn) * turned).norm());
    if (angle > 0.0) {
        const double best = std::atan2(along.dot(turn.cross(turned)) / angle, along.dot(turned));
        const double place = (best < 0.0 ? best + 2.0 * std::numbers::pi : best) / angle;
        if (place < 1.0)
            longest = std::max(longest, (along + rotationOf(place * turn) * turned).norm());
    }
    longest += kRounding * (along.norm() + turned.norm());
    const double rate = m_timing->maxRate(), acceleration = m_timing->maxAcceleration();
    return {rate * longest, acceleration * longest + rate * rate * angle * turned.norm(), rate * angle,
            acceleration * angle};
}

PoseReference StraightMotion::at(double seconds) const {
    if (!m_timing || seconds >= m_timing->duration())
        return {m_to, Twist::Zero()};
    const PathTiming::State state = m_timing->at(seconds);
    return {displaced(m_from, state.s * m_displacement), state.rate * m_displacement};
}

} // namespace hexapose
