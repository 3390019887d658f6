// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/pose.h"
#include "core/kinematics/forward_solver.h"
#include "core/motion/motion_mode.h"
#include "core/record/command_set.h"
#include "core/record/controller_state.h"
#include "core/record/event.h"
#include "core/record/link_state.h"
#include "core/record/motion_id.h"
#include "core/record/run_state.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace hexapose {

/// One cycle of the control loop as a value: all that the screen and the log know. The loop stamps time once.
struct Snapshot {
    std::chrono::nanoseconds time{0};               ///< monotonic, since the session's start
    std::chrono::system_clock::time_point wallTime; ///< for people
    std::uint64_t cycle = 0;
    RunState state = RunState::Disconnected;
    LinkState link = LinkState::Connecting;
    ControllerState controllerState = ControllerState::Unknown;
    bool protectedLink = false;
    CommandSet allowed; ///< the commands that the machine would accept now

    bool fresh = false;              ///< a new measurement arrived in this cycle
    bool stale = true;               ///< the last one is too old to be used
    std::chrono::nanoseconds age{0}; ///< of the last measurement; 0 before the first
    /// Of this cycle's measurement: the controller's clock; how long it came after the set-point that it is
    /// the first to confirm was sent; and how much later after the one before it than the feedback period.
    std::optional<std::chrono::microseconds> controllerTime;
    std::optional<std::chrono::nanoseconds> roundTrip;
    std::optional<std::chrono::nanoseconds> jitter;
    std::optional<LegLengths> measuredLengths;  ///< of the last measurement, m
    std::optional<LegLengths> commandedLengths; ///< set-point in force, m
    std::optional<Pose> targetPose;   ///< where the platform should be now: on the path while moving, and in
                                      ///< joint mode the pose of the set-point in force
    std::optional<Pose> goalPose;     ///< where the present or last Run leads
    std::optional<Pose> measuredPose; ///< of the last measurement; empty unless the solution is usable
    SolveStatus status = SolveStatus::InvalidInput; ///< of the last measurement's solution
    int iterations = 0;
    double residual = 0.0; ///< m
    std::chrono::nanoseconds solveTime{0};

    MotionMode mode = MotionMode::Joint; ///< of the present or last motion
    MotionId motionId = kNoMotion;       ///< of the present or last motion, as its command gave it
    bool held = false;                   ///< the motion is held on its path
    double speed = 1.0;                  ///< 0..1: the operator's speed override
    std::optional<double>
        smallestSingularValue;              ///< of the scaled Jacobian at the measured pose; 0 is singular
    std::optional<double> determinantRatio; ///< q: its determinant over that at home; 0 is singular

    double feedbackRate = 0.0;           ///< Hz, over about the last second
    std::chrono::milliseconds period{0}; ///< feedback period in force; 0: not known
    std::optional<double> minLength;     ///< the controller's own limits, m, once known
    std::optional<double> maxLength;
    LinkCounters counters;
    std::vector<Event> events; ///< empty in an ordinary cycle
};

} // namespace hexapose
