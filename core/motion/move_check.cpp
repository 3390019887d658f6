// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/move_check.h"

#include "core/geometry/singular_values.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/jacobian.h"
#include "core/kinematics/leg_equations.h"
#include "core/kinematics/newton/newton_raphson.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace hexapose {

namespace {

/// The pose at the end of the leg path is the target when it is this close, relative to the machine's size
/// and in rad.
constexpr double kSamePose = 1e-6;
constexpr double kFirstStep = 0.01;    ///< of a leg path
constexpr double kShortestStep = 1e-5; ///< of a leg path
constexpr int kParts = 200;            ///< of a motion
constexpr double kResolution = 1e-5;   ///< of the machine's size: what a part of a motion is divided down to
constexpr double kRateSlack = 1e-2;    ///< of a leg's speed or acceleration: it is read between samples

bool samePose(const PlatformGeometry& geometry, const Pose& a, const Pose& b) {
    const double angle = (rotationMatrix(a.angles) - rotationMatrix(b.angles)).norm();
    return (a.offset - b.offset).norm() <= kSamePose * geometry.size() && angle <= kSamePose;
}

MotionCheck because(MotionCheck::Reason reason) {
    MotionCheck check;
    check.reason = reason;
    return check;
}

MotionCheck alongPath(MotionCheck::Reason reason, double fraction, double value, double bound) {
    MotionCheck check;
    check.reason = reason;
    check.fraction = std::min(fraction, std::nextafter(1.0, 0.0));
    check.value = value;
    check.bound = bound;
    return check;
}

bool expired(PlanTimer* timer) {
    return timer && timer->expired();
}

/// The time is up after this fraction of the path.
MotionCheck tooLong(double fraction) {
    return alongPath(MotionCheck::Reason::PlanTooLong, fraction, 0.0, 0.0);
}

/// The scaled Jacobian at a pose, and what it says.
class JacobianAt {
public:
    JacobianAt(const LegEquations& equations, const Pose& pose)
        : m_equations(&equations),
          m_evaluation(equations.evaluate(equations.placementOf(pose), LegEquations::Legs::Zero())) {
        const LegEquations::Matrix J = equations.jacobian(m_evaluation);
        if (!J.allFinite())
            return;
        m_smallest = singularValues(J)[5];
        m_determinant = J.determinant();
    }
    double smallest() const { return m_smallest; }
    double determinant() const { return m_determinant; }
    /// Lower bound of the smallest singular value within a step of this norm: no singular value changes by
    /// more than the Frobenius norm of the change.
    double smallestWithin(double stepNorm) const {
        return m_smallest - m_equations->jacobianChange(m_evaluation, stepNorm);
    }

private:
    const LegEquations* m_equations;
    LegEquations::Evaluation m_evaluation;
    double m_smallest = 0.0;
    double m_determinant = 0.0;
};

/// Whether the margin holds all along a leg path that changes the lengths (in machine sizes) by `change` in
/// all. While the smallest singular value is above s the platform moves by change / s at most.
bool holdsFor(const JacobianAt& at, double change, double margin) {
    constexpr std::array<double, 5> kSpread{1.05, 1.2, 1.5, 2.0, 4.0};
    return std::any_of(kSpread.begin(), kSpread.end(), [&](double factor) {
        const double least = at.smallestWithin(factor * change / at.smallest());
        return least >= std::max(margin, at.smallest() / factor);
    });
}

/// One motion under judgement.
class MotionChecker {
public:
    MotionChecker(const PlatformGeometry& geometry, const MotionLimits& limits, const PoseMotion& motion,
                  PlanTimer* timer)
        : m_geometry(geometry), m_limits(limits), m_motion(motion), m_timer(timer), m_equations(geometry),
          m_homeDeterminant(JacobianAt(m_equations, Pose{}).determinant()) {
        double reach = 0.0;
        for (const Leg& leg : geometry.legs)
            reach = std::max(reach, leg.p_PB_P.norm());
        m_legSpeedBound = motion.maxSpeed() + motion.maxAngularSpeed() * reach;
        const double centre = m_equations.centroidInP().norm();
        m_jacobianRateBound = (motion.maxSpeed() + motion.maxAngularSpeed() *
                                                       (centre + m_equations.spread() * m_equations.size())) /
                              m_equations.size();
    }

    MotionCheck judge() {
        Sample before = sample(0.0);
        if (const MotionCheck check = judgeSample(before); !check.ok())
            return check;
        const double part = m_motion.duration() / kParts;
        for (int k = 1; k <= kParts; ++k) {
            const Sample after = sample(k == kParts ? m_motion.duration() : k * part);
            if (const MotionCheck check = judgePart(before, after); !check.ok())
                return check;
            if (const MotionCheck check = judgeRates(before, after); !check.ok())
                return check;
            before = after;
        }
        return {};
    }

private:
    struct Sample {
        double time;
        PoseReference reference;
        LegLengths lengths;
        LegLengths rates;
        JacobianAt jacobian;
    };

    Sample sample(double time) const {
        const PoseReference reference = m_motion.at(time);
        return {time, reference, legLengths(m_geometry, reference.pose),
                geometricJacobian(m_geometry, reference.pose) * reference.twist,
                JacobianAt(m_equations, reference.pose)};
    }
    double fraction(double time) const {
        return m_motion.duration() > 0.0 ? time / m_motion.duration() : 1.0;
    }

    MotionCheck judgeSample(const Sample& at) const {
        MotionCheck check = checkLegs(m_limits, at.lengths);
        if (check.ok())
            check = outsideEnvelope(m_limits.envelope, at.reference.pose).value_or(MotionCheck{});
        if (!check.ok()) {
            check.fraction = fraction(at.time);
            return check;
        }
        if (!(at.jacobian.smallest() >= m_limits.singularityMargin))
            return alongPath(MotionCheck::Reason::PathNearSingular, fraction(at.time), at.jacobian.smallest(),
                             m_limits.singularityMargin);
        const double q = at.jacobian.determinant() / m_homeDeterminant;
        if (!(q >= m_limits.leastDeterminantRatio))
            return alongPath(MotionCheck::Reason::WrongSideOfSingularity, fraction(at.time), q,
                             m_limits.leastDeterminantRatio);
        return {};
    }

    /// Between two samples a length that changes by m_legSpeedBound at most cannot be further out than this
    /// says.
    bool strokesHold(const Sample& a, const Sample& b) const {
        const double span = m_legSpeedBound * (b.time - a.time);
        for (int leg = 0; leg < kLegCount; ++leg) {
            const double middle = 0.5 * (a.lengths[leg] + b.lengths[leg]);
            if (middle + 0.5 * span > m_limits.maxLength[leg] ||
                middle - 0.5 * span < m_limits.minLength[leg])
                return false;
        }
        return true;
    }
    bool marginHolds(const Sample& a, const Sample& b) const {
        const double step = 0.5 * m_jacobianRateBound * (b.time - a.time);
        return a.jacobian.smallestWithin(step) >= m_limits.singularityMargin &&
               b.jacobian.smallestWithin(step) >= m_limits.singularityMargin;
    }

    MotionCheck judgePart(const Sample& a, const Sample& b) const {
        if (expired(m_timer))
            return tooLong(fraction(a.time));
        const bool holds = strokesHold(a, b) && marginHolds(a, b);
        if (holds || m_legSpeedBound * (b.time - a.time) <= kResolution * m_geometry.size())
            return judgeSample(b);
        const Sample middle = sample(0.5 * (a.time + b.time));
        if (const MotionCheck check = judgePart(a, middle); !check.ok())
            return check;
        return judgePart(middle, b);
    }

    MotionCheck judgeRates(const Sample& a, const Sample& b) const {
        const double seconds = b.time - a.time;
        for (int leg = 0; leg < kLegCount && seconds > 0.0; ++leg) {
            const double speed = std::abs(b.rates[leg]);
            const double acceleration = std::abs(b.rates[leg] - a.rates[leg]) / seconds;
            MotionCheck check;
            if (speed > m_limits.legSpeed * (1.0 + kRateSlack))
                check = alongPath(MotionCheck::Reason::LegSpeed, fraction(b.time), speed, m_limits.legSpeed);
            else if (acceleration > m_limits.legAcceleration * (1.0 + kRateSlack))
                check = alongPath(MotionCheck::Reason::LegAcceleration, fraction(b.time), acceleration,
                                  m_limits.legAcceleration);
            check.leg = check.ok() ? 0 : leg + 1;
            if (!check.ok())
                return check;
        }
        return {};
    }

    const PlatformGeometry& m_geometry;
    const MotionLimits& m_limits;
    const PoseMotion& m_motion;
    PlanTimer* m_timer; ///< null: no hurry
    LegEquations m_equations;
    double m_homeDeterminant;
    double m_legSpeedBound;     ///< m/s: no leg changes faster
    double m_jacobianRateBound; ///< 1/s: no step of the placement is longer in a second
};

} // namespace

MotionCheck checkLegPath(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& from,
                         const Pose& to, PlanTimer* timer) {
    const MotionCheck target = checkPose(geometry, limits, to);
    if (!target.ok())
        return target;
    if (!from.isFinite())
        return because(MotionCheck::Reason::NotFinite);

    // Legs plus the sign of det J do not identify a pose; the path followed does.
    const NewtonRaphson newton(geometry, NewtonOptions{});
    const LegEquations equations(geometry);
    const LegLengths start = legLengths(geometry, from);
    const LegLengths way = legLengths(geometry, to) - start;
    const double length = way.norm() / equations.size();
    Pose pose = from;
    JacobianAt here(equations, pose);
    double done = 0.0;
    double step = kFirstStep;
    while (done < 1.0) {
        if (expired(timer))
            return tooLong(done);
        step = std::min(step, 1.0 - done);
        while (step > kShortestStep && !holdsFor(here, step * length, limits.singularityMargin))
            step *= 0.5;
        const double fraction = std::min(done + step, 1.0);
        const ForwardResult next = newton.solve(start + fraction * way, pose);
        const bool found = next.status == SolveStatus::Converged;
        const JacobianAt there(equations, found ? next.pose : pose);
        const double margin = found ? there.smallest() : 0.0;
        if (!(margin >= limits.singularityMargin))
            return alongPath(MotionCheck::Reason::PathNearSingular, fraction, margin,
                             limits.singularityMargin);
        if (auto outside = outsideEnvelope(limits.envelope, next.pose)) {
            outside->fraction = fraction;
            return *outside;
        }
        pose = next.pose;
        here = there;
        done = fraction;
        step = std::min(2.0 * step, kFirstStep);
    }
    if (!samePose(geometry, pose, to))
        return because(MotionCheck::Reason::OtherAssemblyMode);
    return {};
}

MotionCheck checkMotion(const PlatformGeometry& geometry, const MotionLimits& limits,
                        const PoseMotion& motion, PlanTimer* timer) {
    if (!motion.at(0.0).pose.isFinite() || !motion.at(motion.duration()).pose.isFinite() ||
        !std::isfinite(motion.duration()))
        return because(MotionCheck::Reason::NotFinite);
    return MotionChecker(geometry, limits, motion, timer).judge();
}

} // namespace hexapose
