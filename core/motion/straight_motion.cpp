// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/straight_motion.h"

#include "core/kinematics/jacobian.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapose {

namespace {

constexpr double kMargin = 0.995;   ///< of a limit that holds along the way: the plan is made of steps
constexpr int kLegSamples = 200;    ///< of the legs' accelerations
constexpr int kReplans = 8;         ///< for them
constexpr double kNoLength = 1e-12; ///< of the machine's size, and rad

/// A limit of s from a limit of what grows by `length` over the whole way.
double share(double limit, double length) {
    return length > 0.0 ? limit / length : std::numeric_limits<double>::infinity();
}

/// Largest acceleration of any leg over the motion.
double largestLegAcceleration(const PlatformGeometry& geometry, const StraightMotion& motion,
                              PlanTimer* timer) {
    const double duration = motion.duration();
    const double step = duration / kLegSamples;
    const auto rates = [&](double t) {
        const PoseReference reference = motion.at(t);
        return (geometricJacobian(geometry, reference.pose) * reference.twist).eval();
    };
    LegLengths before = rates(0.0);
    double largest = 0.0;
    for (int k = 1; k <= kLegSamples && !(timer && timer->expired()); ++k) {
        const LegLengths now = rates(k * step);
        largest = std::max(largest, (now - before).cwiseAbs().maxCoeff() / step);
        before = now;
    }
    return largest;
}

} // namespace

StraightMotion::StraightMotion(const PlatformGeometry& geometry, const Pose& from, const Pose& to,
                               const MotionBounds& bounds, PlanTimer* timer)
    : m_from(from), m_to(to), m_displacement(displacement(from, to)) {
    const double length = m_displacement.head<3>().norm();
    const double turn = m_displacement.tail<3>().norm();
    if (length <= kNoLength * geometry.size() && turn <= kNoLength)
        return;
    PathBounds path{std::min(share(bounds.speed, length), share(bounds.angularSpeed, turn)),
                    std::min(share(bounds.acceleration, length), share(bounds.angularAcceleration, turn)),
                    std::min(share(bounds.jerk, length), share(bounds.angularJerk, turn))};
    double legSpeed = kMargin * bounds.legSpeed;
    const auto largestRate = [&](double s) {
        const Pose pose = displaced(m_from, s * m_displacement);
        return share(legSpeed, (geometricJacobian(geometry, pose) * m_displacement).cwiseAbs().maxCoeff());
    };
    // Where the legs would be accelerated too hard all of the motion is slowed down.
    for (int plan = 0; plan < kReplans; ++plan) {
        if (!timer)
            m_timing.emplace(path, largestRate);
        else if (m_timing = PathTiming::plan(path, largestRate, *timer); !m_timing)
            return;
        const double excess = largestLegAcceleration(geometry, *this, timer) / bounds.legAcceleration;
        if (excess <= 1.0)
            break;
        const double slower = kMargin / std::sqrt(excess);
        path = {path.rate * slower, path.acceleration * slower * slower,
                path.jerk * slower * slower * slower};
        legSpeed *= slower;
    }
    m_fastestRate = path.rate;
    for (int k = 0; k <= kLegSamples; ++k)
        m_fastestRate = std::max(m_fastestRate, m_timing->at(duration() * k / kLegSamples).rate);
}

std::optional<StraightMotion> StraightMotion::plan(const PlatformGeometry& geometry, const Pose& from,
                                                   const Pose& to, const MotionBounds& bounds,
                                                   PlanTimer& timer) {
    StraightMotion motion(geometry, from, to, bounds, &timer);
    return timer.expired() ? std::nullopt : std::optional(std::move(motion));
}

PoseReference StraightMotion::at(double seconds) const {
    if (!m_timing || seconds >= m_timing->duration())
        return {m_to, Twist::Zero()};
    const PathTiming::State state = m_timing->at(seconds);
    return {displaced(m_from, state.s * m_displacement), state.rate * m_displacement};
}

} // namespace hexapose
