// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/pose.h"
#include "core/motion/jog.h"
#include "core/motion/motion_mode.h"
#include "core/motion/motion_planner.h"
#include "core/motion/sine_sweep.h"
#include "core/record/motion_id.h"

#include <memory>
#include <variant>

namespace hexapose {

/// To a pose: reference and enable first, where that is still due.
struct RunCommand {
    Pose target; ///< of P from home, base frame
    MotionMode mode = MotionMode::Joint;
    MotionId id = kNoMotion; ///< the asker's, so that it knows its own motion again in the snapshots
    /// Planned already by who asks, with the model of the session: a screen that has planned the request to
    /// say whether it can be carried out sends what came of it, and the request is planned once. The loop
    /// takes the plan if it is of this target and mode, was made with the loop's own bounds, and its start
    /// and limits are those of now, and checks start and limits again when the motion begins. Otherwise, and
    /// where no plan came, its planner makes one beside the cycle. Left empty by whoever does not plan or
    /// does not know the start: a jog's step, the report's list, VisitJob (whose targets are planned at their
    /// begin, each from where the one before ended), a program of its own.
    SharedPlan plan = {};
};
/// A sine sweep about the pose where the platform is, in workspace mode.
struct SweepCommand {
    SweepSettings settings;
    MotionId id = kNoMotion;
};
/// A jog button is held: repeated at least every 150 ms, or the jog comes to rest. All repeats of one press
/// carry its id: a press that was released, that was not repeated in time, or whose jog has ended otherwise
/// starts nothing more. Without an id a repeat after the end is a new press.
struct JogCommand {
    JogDirection direction;
    double speedOverride = 1.0; ///< 0..1 of full speed
    MotionId id = kNoMotion;
};
/// The button was let go.
struct JogReleaseCommand {};
/// Speed override of everything that moves, 0..1.
struct SpeedCommand {
    double speedOverride = 1.0;
};
/// Holds the present motion on its path; until Resume, or until something ends the motion.
struct HoldCommand {};
struct ResumeCommand {};
struct StopCommand {};
struct ReferenceCommand {};
struct EnableCommand {};
struct DisableCommand {};
struct ClearCommand {};

/// What an operator, or a program in their place, can ask for.
using OperatorCommand =
    std::variant<RunCommand, SweepCommand, JogCommand, JogReleaseCommand, SpeedCommand, HoldCommand,
                 ResumeCommand, StopCommand, ReferenceCommand, EnableCommand, DisableCommand, ClearCommand>;

} // namespace hexapose
