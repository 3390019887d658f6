// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/pose.h"
#include "core/motion/jog.h"
#include "core/motion/motion_mode.h"
#include "core/motion/sine_sweep.h"

#include <variant>

namespace hexapose {

/// To a pose: reference and enable first, where that is still due.
struct RunCommand {
    Pose target;
    MotionMode mode = MotionMode::Joint;
};
/// A sine sweep about the pose where the platform is, in workspace mode.
struct SweepCommand {
    SweepSettings settings;
};
/// A jog button is held: said again at least every 150 ms, or the jog comes to rest.
struct JogCommand {
    JogDirection direction;
    double part = 1.0; ///< 0..1 of full speed
};
/// The button was let go.
struct JogReleaseCommand {};
/// Part of full speed for everything that moves, 0..1. 0 holds a motion on its path.
struct SpeedCommand {
    double part = 1.0;
};
struct StopCommand {};
struct ReferenceCommand {};
struct EnableCommand {};
struct DisableCommand {};
struct ClearCommand {};

/// What an operator, or a program in their place, can ask for.
using OperatorCommand =
    std::variant<RunCommand, SweepCommand, JogCommand, JogReleaseCommand, SpeedCommand, StopCommand,
                 ReferenceCommand, EnableCommand, DisableCommand, ClearCommand>;

} // namespace hexapose
