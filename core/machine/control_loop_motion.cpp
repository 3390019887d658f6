// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// From a wish to a motion that is under way, and to its end.

#include "core/kinematics/inverse_kinematics.h"
#include "core/machine/control_loop_impl.h"
#include "core/motion/leg_path_check.h"
#include "core/motion/pose_motion_check.h"
#include "core/motion/straight_motion.h"
#include "core/tracking/joint_motion.h"
#include "core/tracking/workspace_motion.h"

namespace hexapose {

namespace {

using Following = WorkspaceController::Following;

/// What is measured may come so much nearer to a singular pose than a move may be planned.
constexpr double kMeasuredMargin = 0.5;

} // namespace

Move::Timing ControlLoop::Impl::timing() const {
    return {options.settleTime, options.settleTimeout, options.enableTimeout, options.referenceTimeout};
}

/// Why nothing can move now, whatever is asked for.
std::optional<std::string> ControlLoop::Impl::unfitToMove() const {
    if (monitor.stale())
        return "stale data";
    if (!measuredPose)
        return std::string(toWord(solution.status));
    return std::nullopt;
}

/// The last gate for what is measured: singularity and side.
std::optional<Event> ControlLoop::Impl::nearLimit() const {
    const MotionLimits bounds = limits();
    if (!(singularity.smallestSingularValue >= kMeasuredMargin * bounds.singularityMargin) ||
        !(singularity.determinant / homeDeterminant > 0.0))
        return Event{EventCode::StoppedOnLimits, 0.0, toWords({MotionCheck::Reason::NearSingular})};
    return std::nullopt;
}

ControlLoop::Impl::Planned ControlLoop::Impl::plan(const MotionWish& what, bool withLaw) {
    Planned planned;
    const MotionLimits bounds = limits();
    const LegLengths from = commanded.value_or(withLaw ? holdPoint() : *measured);
    const auto* run = std::get_if<RunCommand>(&what);
    if (run && run->mode == MotionMode::Joint) {
        planned.check = checkLegPath(geometry, bounds, *measuredPose, run->target);
        if (planned.check.ok() && withLaw)
            planned.law = std::make_unique<JointMotion>(from, legLengths(geometry, run->target),
                                                        options.bounds.legSpeed);
        return planned;
    }
    if (run) { // a target that cannot be is not worth a plan
        planned.check = checkPose(geometry, bounds, run->target);
        if (!planned.check.ok())
            return planned;
    }
    std::unique_ptr<const PoseMotion> motion;
    if (run)
        motion = std::make_unique<StraightMotion>(geometry, *measuredPose, run->target, options.bounds);
    else
        motion = std::make_unique<SineSweep>(*measuredPose, std::get<SweepCommand>(what).settings);
    const LegLengths here = legLengths(geometry, motion->at(0.0).pose);
    planned.check = checkMotion(geometry, limitsFrom(bounds, here, options.settleWindow.distance), *motion);
    if (planned.check.ok() && withLaw)
        planned.law = std::make_unique<WorkspaceMotion>(workspace, std::move(motion),
                                                        run ? Following::Path : Following::Time, from);
    return planned;
}

/// Judges a wish and, if it can be, gets the drives ready for it.
void ControlLoop::Impl::prepareMotion(const MotionWish& what, MachineEvent event, Clock::time_point time) {
    if (!takesCommands() || !accepts(event) || (move && !moving()))
        return refuse(event);
    if (const auto why = unfitToMove())
        return raise({EventCode::MoveRefused, 0.0, *why});
    const Planned planned = plan(what, false);
    if (!planned.check.ok())
        return raise({EventCode::MoveRefused, 0.0, toWords(planned.check)});
    apply(event);
    move.emplace(feedback.state, timing(), time);
    wish = what;
    askToReference();
    enableTries = kTriesAgain;
    const auto* run = std::get_if<RunCommand>(&what);
    goal = run ? run->target : *measuredPose;
    tookOver = true;
    if (move->phase() == Move::Phase::Referencing)
        raise({EventCode::Referencing, 0.0, {}});
}

/// The drives are on. Referencing may have moved the legs: the path is judged again from where they are now.
void ControlLoop::Impl::beginMotion(Clock::time_point time) {
    Planned planned = plan(*wish, true);
    if (!planned.check.ok()) {
        raise({EventCode::MoveRefused, 0.0, toWords(planned.check)});
        return dropMotion();
    }
    law = std::move(planned.law);
    jog = nullptr;
    mode = law->mode();
    wish.reset();
    move->begin(time);
    lastStep = time;
    apply(MachineEvent::PathBegins);
    raise({EventCode::MoveStarted, law->duration(), {}});
}

void ControlLoop::Impl::advanceMove(Clock::time_point time) {
    if (law)
        if (std::optional<Event> event = law->takeEvent())
            raise(std::move(*event));
    if (!move)
        return;
    const bool fresh = law && feedback.lengths && measuredPose;
    const std::optional<bool> inside =
        fresh ? std::optional(law->inPosition(*feedback.lengths, *measuredPose, options.settleWindow))
              : std::nullopt;
    const bool wasMoving = move->phase() == Move::Phase::Moving;
    if (std::optional<Event> event = move->update(feedback.state, law && law->finished(), inside, time))
        raise(std::move(*event));
    if (wasMoving && move->phase() == Move::Phase::Settling)
        apply(MachineEvent::PathEnds);
    if (move->phase() == Move::Phase::Failed)
        return dropMotion();
    if (move->phase() == Move::Phase::Settled) {
        apply(MachineEvent::Settles);
        move.reset();
        if (law->mode() == MotionMode::Joint)
            law.reset(); // the set-point is held from here on; in workspace mode the pose is
        return;
    }
    if (move->phase() == Move::Phase::Ready && feedback.state == ControllerState::Enabled && measuredPose &&
        measured)
        beginMotion(time);
}

} // namespace hexapose
