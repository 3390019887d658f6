// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device/simulation/virtual_platform.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"
#include "core/kinematics/forward_solver.h"
#include "core/machine/control_loop.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hexapose::experiment {

/// What is tried, and under what disturbance.
struct TrialSettings {
    PlatformGeometry platform;
    VirtualPlatformOptions legs;
    ControlOptions control;
    int moves = 20;
    std::uint64_t seed = 1;
    double push = 2e-3;       ///< m, of one leg after the other during each move; 0: none
    double pushSeconds = 0.6; ///< from 40 % of the planned time on
};

/// One moment of a move, by the true lengths and not the reported ones.
struct Moment {
    double seconds;        ///< since the path began
    double deviation;      ///< m, of P from the straight line
    double angleDeviation; ///< rad, from the rotation that belongs to the place on the line
    double speed;          ///< m/s, of P, over the last 100 ms
    double plannedSpeed;   ///< m/s, of the trajectory where the reference is
};

/// How one move went.
struct MoveOutcome {
    Pose from, to;
    std::vector<Moment> moments;
    double plannedSeconds = 0.0;        ///< of the path
    double largestDeviation = 0.0;      ///< m
    double largestAngleDeviation = 0.0; ///< rad
    std::optional<double>
        settleSeconds;       ///< from the end of the path to the end of settling; nothing: it did not settle
    double finalError = 0.0; ///< m, of P when it had settled
    double finalAngle = 0.0; ///< rad
    /// Largest part by which the speed differs from the commanded one, where that has been constant for 0.35
    /// s and no push is near; nothing where there is no such part, or nothing was commanded (joint mode).
    std::optional<double> speedError;
};

/// Targets within reach from one to the next, by straight leg paths and by straight paths in the workspace.
std::vector<Pose> drawTargets(const TrialSettings& settings);

/// All targets in turn, by the whole control loop, bytes and all. progress: 0..1. Throws InputError, naming
/// the move, when one is refused or stopped.
std::vector<MoveOutcome> runTrial(const TrialSettings& settings, const ForwardSolver& solver,
                                  const std::vector<Pose>& targets, MotionMode mode,
                                  const std::function<void(double)>& progress);

} // namespace hexapose::experiment
