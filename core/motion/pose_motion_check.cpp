// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/pose_motion_check.h"

#include "core/geometry/twist.h"
#include "core/motion/path_sample.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr int kParts = 200;          ///< of a motion
constexpr double kResolution = 1e-5; ///< of the machine's size: what a part of a motion is divided down to
constexpr double kRateSlack = 1e-2;  ///< of a leg's speed or acceleration: it is read between samples

/// One motion under check. Distances are in machine sizes here, and taken about the centroid of the platform
/// joints: where P was put does not matter.
class MotionChecker {
public:
    MotionChecker(const PlatformModel& model, const MotionLimits& limits, const PoseMotion& motion,
                  PlanTimer* timer)
        : m_limits(limits), m_motion(motion), m_timer(timer), m_model(model), m_equations(model.equations()),
          m_centroid(m_equations.centroidInP() * m_equations.size()),
          m_bounds(motion.rateBounds(m_centroid)) {
        m_bounds.speed /= m_equations.size();
        m_bounds.acceleration /= m_equations.size();
    }

    MotionCheck check() {
        Sample before = sample(0.0);
        if (const MotionCheck check = checkSample(before); !check.ok())
            return check;
        const double part = m_motion.duration() / kParts;
        for (int k = 1; k <= kParts; ++k) {
            const Sample after = sample(k == kParts ? m_motion.duration() : k * part);
            if (const MotionCheck check = checkSegment(before, after); !check.ok())
                return check;
            if (const MotionCheck check = checkRates(before, after); !check.ok())
                return check;
            before = after;
        }
        return {};
    }

private:
    struct Sample {
        double time;
        Pose pose;
        PathSample path;
        LegLengths lengths; ///< m
        LegVector rates;    ///< m/s
    };

    Sample sample(double time) const {
        const PoseReference reference = m_motion.at(time);
        const PathSample path(m_equations, m_equations.placementOf(reference.pose));
        const double size = m_equations.size();
        const Eigen::Vector3d angular = reference.twist.tail<3>();
        Twist centroid;
        centroid << (reference.twist.head<3>() +
                     angular.cross(rotationMatrix(reference.pose.angles) * m_centroid)),
            angular * (m_equations.spread() * size);
        return {time, reference.pose, path, path.evaluation().length.matrix() * size,
                path.jacobian() * centroid};
    }
    double fraction(double time) const {
        return m_motion.duration() > 0.0 ? time / m_motion.duration() : 1.0;
    }

    MotionCheck checkSample(const Sample& at) const {
        MotionCheck check = checkLegs(m_limits, at.lengths);
        if (check.ok())
            check = outsideEnvelope(m_limits.envelope, at.pose).value_or(MotionCheck{});
        if (!check.ok()) {
            check.fraction = fraction(at.time);
            return check;
        }
        if (!(at.path.smallestSingularValue() >= m_limits.singularityMargin))
            return failedAlongPath(MotionCheck::Reason::PathNearSingular, fraction(at.time),
                                   at.path.smallestSingularValue(), m_limits.singularityMargin);
        const double q = m_model.ratioOf(at.path.determinant());
        if (!(q >= m_limits.leastDeterminantRatio))
            return failedAlongPath(MotionCheck::Reason::WrongSideOfSingularity, fraction(at.time), q,
                                   m_limits.leastDeterminantRatio);
        return {};
    }

    /// No joint goes further in this time.
    double jointTravel(double seconds, double arm) const {
        return (m_bounds.speed + m_bounds.angularSpeed * arm) * seconds;
    }
    /// Between two samples a length leaves the straight line between theirs by |l''| seconds^2 / 8 at most.
    /// l'' = n a + (|u|^2 - (n u)^2) / l, with u and a the speed and acceleration of its platform joint.
    bool strokesHold(const Sample& a, const Sample& b) const {
        const double seconds = b.time - a.time;
        for (int leg = 0; leg < kLegCount; ++leg) {
            const double arm = a.path.arms()[leg];
            const double travel = jointTravel(seconds, arm);
            const double longest = std::max(a.lengths[leg], b.lengths[leg]);
            const double shortest = std::min(a.lengths[leg], b.lengths[leg]);
            const double least = longest / m_equations.size() - travel;
            if (!(least > 0.0))
                return false;
            const double acceleration =
                m_bounds.acceleration +
                (m_bounds.angularAcceleration + m_bounds.angularSpeed * m_bounds.angularSpeed) * arm;
            const double bulge =
                (acceleration * seconds * seconds + travel * travel / least) / 8.0 * m_equations.size();
            if (longest + bulge > m_limits.maxLength[leg] || shortest - bulge < m_limits.minLength[leg])
                return false;
        }
        return true;
    }
    bool marginHolds(const Sample& a, const Sample& b) const {
        const double half = 0.5 * (b.time - a.time);
        const auto holds = [&](const PathSample& path) {
            const double change = path.jacobianChange(m_bounds.speed * half, m_bounds.angularSpeed * half);
            return change <= kMarginResolution ||
                   path.smallestSingularValue() - change >= m_limits.singularityMargin;
        };
        return holds(a.path) && holds(b.path);
    }

    MotionCheck checkSegment(const Sample& a, const Sample& b) const {
        if (expired(m_timer))
            return failedAlongPath(MotionCheck::Reason::PlanTooLong, fraction(a.time), 0.0, 0.0);
        const bool holds = strokesHold(a, b) && marginHolds(a, b);
        if (holds || jointTravel(b.time - a.time, a.path.arms().maxCoeff()) <= kResolution)
            return checkSample(b);
        const Sample middle = sample(0.5 * (a.time + b.time));
        if (const MotionCheck check = checkSegment(a, middle); !check.ok())
            return check;
        return checkSegment(middle, b);
    }

    MotionCheck checkRates(const Sample& a, const Sample& b) const {
        const double seconds = b.time - a.time;
        for (int leg = 0; leg < kLegCount && seconds > 0.0; ++leg) {
            const double speed = std::abs(b.rates[leg]);
            const double acceleration = std::abs(b.rates[leg] - a.rates[leg]) / seconds;
            MotionCheck check;
            if (speed > m_limits.legSpeed * (1.0 + kRateSlack))
                check = failedAlongPath(MotionCheck::Reason::LegSpeed, fraction(b.time), speed,
                                        m_limits.legSpeed);
            else if (acceleration > m_limits.legAcceleration * (1.0 + kRateSlack))
                check = failedAlongPath(MotionCheck::Reason::LegAcceleration, fraction(b.time), acceleration,
                                        m_limits.legAcceleration);
            check.leg = check.ok() ? 0 : leg + 1;
            if (!check.ok())
                return check;
        }
        return {};
    }

    const MotionLimits& m_limits;
    const PoseMotion& m_motion;
    PlanTimer* m_timer; ///< null: no limit of time
    const PlatformModel& m_model;
    const LegEquations& m_equations;
    Eigen::Vector3d m_centroid; ///< from P, platform frame, m
    RateBounds m_bounds;        ///< of the centroid, in machine sizes, and of the turning
};

} // namespace

MotionCheck checkMotion(const PlatformModel& model, const MotionLimits& limits, const PoseMotion& motion,
                        PlanTimer* timer) {
    if (!motion.at(0.0).pose.isFinite() || !motion.at(motion.duration()).pose.isFinite() ||
        !std::isfinite(motion.duration())) {
        MotionCheck check;
        check.reason = MotionCheck::Reason::NotFinite;
        return check;
    }
    return MotionChecker(model, limits, motion, timer).check();
}

} // namespace hexapose
