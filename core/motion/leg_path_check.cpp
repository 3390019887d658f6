// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/leg_path_check.h"

#include "core/kinematics/newton/newton_iteration.h"
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
constexpr double kTolerance = 1e-10; ///< of the pose at a step: norm of the leg errors, machine sizes
constexpr int kMostIterations = 50;

bool isSamePose(const PlatformModel& model, const Pose& a, const Pose& b) {
    const double angle = (rotationMatrix(a.angles) - rotationMatrix(b.angles)).norm();
    return (a.offset - b.offset).norm() <= kSamePose * model.size() && angle <= kSamePose;
}

/// Whether the margin holds while the legs go on by `step` of the path from a sample where the platform goes
/// by `speed` a path, (centroid, turn times spread) in machine sizes. From x' = J^-1 l' with l' constant,
/// |x''| <= |J'| |x'| / s while the smallest singular value is above s, and |J'| <= L |x'|: the speed has
/// grown by a factor f at most for as long as L speed step / s <= 1 - 1/f.
bool holdsFor(const PathSample& at, double spread, double speed, double step, double margin) {
    constexpr std::array<double, 5> kGrowths{1.05, 1.2, 1.5, 2.0, 4.0};
    return std::any_of(kGrowths.begin(), kGrowths.end(), [&](double growth) {
        const double travel = growth * speed * step;
        const double change = at.jacobianChange(travel, travel / spread);
        const double least = at.smallestSingularValue() - change;
        if (!(least > 0.0) || (least < margin && change > kMarginResolution))
            return false;
        return change / growth / least <= 1.0 - 1.0 / growth;
    });
}

/// A path of straight leg lengths, and where the platform is on it.
class LegPathWalk {
public:
    LegPathWalk(const PlatformModel& model, const Pose& from, const Pose& to)
        : m_model(model), m_equations(model.equations()), m_start(m_equations.scaled(model.actuators(from))),
          m_change(m_equations.scaled(model.actuators(to)) - m_start),
          m_placement(m_equations.placementOf(from)), m_sample(m_equations, m_placement) {}

    Pose pose() const { return m_equations.poseOf(m_placement); }
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
    /// Goes on by a step; false where there is no pose on home's side.
    bool advance(double step) {
        m_step = step;
        m_done = std::min(m_done + step, 1.0);
        const NewtonRun run = runNewton(m_equations, m_start + m_done * m_change, m_placement, kTolerance,
                                        kMostIterations, StepGuard::Shorten);
        if (run.end != NewtonEnd::Solved)
            return false;
        m_placement = run.placement;
        m_sample = PathSample(m_equations, m_placement);
        return m_model.ratioOf(m_sample.determinant()) > 0.0;
    }

private:
    /// By which the platform goes on a path from here.
    double speedAlongPath() const {
        LegEquations::Evaluation along = m_sample.evaluation();
        along.error = m_change;
        LegEquations::Step step;
        if (m_equations.newtonStep(along, step) == 0.0)
            return std::numeric_limits<double>::infinity();
        return step.norm();
    }

    const PlatformModel& m_model;
    const LegEquations& m_equations;
    LegEquations::Legs m_start;
    LegEquations::Legs m_change;
    Placement m_placement;
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

MotionCheck checkLegPath(const PlatformModel& model, const MotionLimits& limits, const Pose& from,
                         const Pose& to, PlanTimer* timer) {
    const MotionCheck target = checkPose(model, limits, to);
    if (!target.ok())
        return target;
    if (!from.isFinite())
        return because(MotionCheck::Reason::NotFinite);
    // Legs plus the sign of det J do not identify a pose; the path followed does.
    LegPathWalk walk(model, from, to);
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
    if (!isSamePose(model, walk.pose(), to))
        return because(MotionCheck::Reason::OtherAssemblyMode);
    return {};
}

} // namespace hexapose
