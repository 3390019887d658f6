// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/leg_path_check.h"

#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/motion/path_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hexapose {

namespace {

/// The pose at the end of the path is the target when it is this close, relative to the machine's size and in
/// rad.
constexpr double kSamePose = 1e-6;
constexpr double kLongestStep = 0.01; ///< of the path
constexpr double kShortestStep = 1e-5;

bool isSamePose(const PlatformGeometry& geometry, const Pose& a, const Pose& b) {
    const double angle = (rotationMatrix(a.angles) - rotationMatrix(b.angles)).norm();
    return (a.offset - b.offset).norm() <= kSamePose * geometry.size() && angle <= kSamePose;
}

/// Whether the margin holds while the legs go on by `step` of the path from a sample where the platform goes
/// by `speed` a path, (centroid, turn times spread) in machine sizes. From x' = J^-1 l' with l' constant,
/// |x''| <= |J'| |x'| / s while the smallest singular value is above s, and |J'| <= L |x'|: the speed has
/// grown by a factor f at most for as long as L speed step / s <= 1 - 1/f.
bool holdsFor(const PathSample& at, double spread, double speed, double step, double margin) {
    constexpr std::array<double, 5> kGrowths{1.05, 1.2, 1.5, 2.0, 4.0};
    return std::any_of(kGrowths.begin(), kGrowths.end(), [&](double growth) {
        const double way = growth * speed * step;
        const double change = at.jacobianChange(way, way / spread);
        const double least = at.smallestSingularValue() - change;
        if (!(least > 0.0) || (least < margin && change > kMarginResolution))
            return false;
        return change / growth / least <= 1.0 - 1.0 / growth;
    });
}

/// A path of straight leg lengths, and the pose on it.
class LegPathWalk {
public:
    LegPathWalk(const PlatformGeometry& geometry, const Pose& from, const Pose& to)
        : m_newton(geometry, NewtonOptions{}), m_equations(geometry), m_start(legLengths(geometry, from)),
          m_change(legLengths(geometry, to) - m_start), m_scaledEnd(m_equations.scaled(m_start + m_change)),
          m_pose(from), m_sample(m_equations, from) {}

    const Pose& pose() const { return m_pose; }
    double done() const { return m_done; }
    double smallestSingularValue() const { return m_sample.smallestSingularValue(); }

    /// How far the margin is known to hold from here, of the path.
    double nextStep(double margin) const {
        double step = std::min({2.0 * m_step, kLongestStep, 1.0 - m_done});
        const double speed = speedAlongPath();
        while (step > kShortestStep && !holdsFor(m_sample, m_equations.spread(), speed, step, margin))
            step *= 0.5;
        return step;
    }
    /// Goes on by a step; false where there is no pose.
    bool advance(double step) {
        m_step = step;
        m_done = std::min(m_done + step, 1.0);
        const ForwardResult next = m_newton.solve(m_start + m_done * m_change, m_pose);
        if (next.status != SolveStatus::Converged)
            return false;
        m_pose = next.pose;
        m_sample = PathSample(m_equations, m_pose);
        return true;
    }

private:
    /// By which the platform goes on a path from here.
    double speedAlongPath() const {
        LegEquations::Evaluation toEnd = m_sample.evaluation();
        toEnd.error = m_scaledEnd - toEnd.length;
        LegEquations::Step step;
        if (m_equations.newtonStep(toEnd, step) == 0.0)
            return std::numeric_limits<double>::infinity();
        return step.norm() / (1.0 - m_done);
    }

    NewtonRaphson m_newton;
    LegEquations m_equations;
    LegLengths m_start;
    LegLengths m_change;
    LegEquations::Legs m_scaledEnd;
    Pose m_pose;
    PathSample m_sample;
    double m_done = 0.0;
    double m_step = kLongestStep;
};

MotionCheck because(MotionCheck::Reason reason) {
    MotionCheck check;
    check.reason = reason;
    return check;
}

} // namespace

MotionCheck checkLegPath(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& from,
                         const Pose& to, PlanTimer* timer) {
    const MotionCheck target = checkPose(geometry, limits, to);
    if (!target.ok())
        return target;
    if (!from.isFinite())
        return because(MotionCheck::Reason::NotFinite);
    // Legs plus the sign of det J do not identify a pose; the path followed does.
    LegPathWalk walk(geometry, from, to);
    while (walk.done() < 1.0) {
        if (expired(timer))
            return failedAlongPath(MotionCheck::Reason::PlanTooLong, walk.done(), 0.0, 0.0);
        const bool found = walk.advance(walk.nextStep(limits.singularityMargin));
        const double margin = found ? walk.smallestSingularValue() : 0.0;
        if (!(margin >= limits.singularityMargin))
            return failedAlongPath(MotionCheck::Reason::PathNearSingular, walk.done(), margin,
                                   limits.singularityMargin);
        if (auto outside = outsideEnvelope(limits.envelope, walk.pose())) {
            outside->fraction = walk.done();
            return *outside;
        }
    }
    if (!isSamePose(geometry, walk.pose(), to))
        return because(MotionCheck::Reason::OtherAssemblyMode);
    return {};
}

} // namespace hexapose
