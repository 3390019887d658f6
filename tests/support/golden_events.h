// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/event.h"

#include <vector>

namespace hexapose {

/// Every event that the loop, the session or the console can raise, with its words in the log.
struct GoldenEvent {
    const char* words;
    Event event;
};

inline MotionCheck checkOf(MotionCheck::Reason reason, int leg, double fraction, int axis = 0) {
    MotionCheck check;
    check.reason = reason;
    check.leg = leg;
    check.axis = axis;
    check.fraction = fraction;
    check.value = 0.3512;
    check.bound = 0.35;
    return check;
}

// clang-format off
inline const std::vector<GoldenEvent> kGoldenEvents{
    {"connected rig", {EventCode::Connected, DeviceText{"rig"}}},
    {"listen-only", {EventCode::ListenOnly}},
    {"link-lost /dev/ttyX: the port is gone", {EventCode::LinkLost, PortFailure{PortFailure::Kind::Gone, "/dev/ttyX", {}}}},
    {"link-lost /dev/ttyX: No such file or directory", {EventCode::LinkLost, PortFailure{PortFailure::Kind::NotFound, "/dev/ttyX", {}}}},
    {"link-lost /dev/ttyX: not a serial port", {EventCode::LinkLost, PortFailure{PortFailure::Kind::NotAPort, "/dev/ttyX", {}}}},
    {"link-lost /dev/ttyX: no permission. Add yourself to the group of serial ports (sudo usermod -aG dialout $USER), then log in again",
     {EventCode::LinkLost, PortFailure{PortFailure::Kind::NoPermission, "/dev/ttyX", {}}}},
    {"link-lost /dev/ttyX: another program has it open (4711)", {EventCode::LinkLost, PortFailure{PortFailure::Kind::Busy, "/dev/ttyX", "4711"}}},
    {"link-lost /dev/ttyX: not opened as a serial port: 25", {EventCode::LinkLost, PortFailure{PortFailure::Kind::NotOpened, "/dev/ttyX", "25"}}},
    {"link-lost /dev/ttyX: the port takes no bytes", {EventCode::LinkLost, PortFailure{PortFailure::Kind::NotTaking, "/dev/ttyX", {}}}},
    {"link-lost /dev/ttyX: the port is closed", {EventCode::LinkLost, PortFailure{PortFailure::Kind::Closed, "/dev/ttyX", {}}}},
    {"link-lost /dev/ttyX: EIO", {EventCode::LinkLost, PortFailure{PortFailure::Kind::Other, "/dev/ttyX", "EIO"}}},
    {"data-stale 250.5", {EventCode::DataStale, 250.5}},
    {"data-fresh", {EventCode::DataFresh}},
    {"referencing", {EventCode::Referencing}},
    {"referenced", {EventCode::Referenced}},
    {"enabled", {EventCode::Enabled}},
    {"disabled", {EventCode::Disabled}},
    {"move-started 1.25", {EventCode::MoveStarted, 1.25}},
    {"move-refused leg 3 above max_mm", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::LegAboveMax, 3, 1.0)}},
    {"move-refused leg 2 below min_mm at 12 %", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::LegBelowMin, 2, 0.12)}},
    {"move-refused invalid-input", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::NotFinite, 0, 1.0)}},
    {"move-refused near singular", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::NearSingular, 0, 1.0)}},
    {"move-refused other branch", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::OtherAssemblyMode, 0, 1.0)}},
    {"move-refused path near singular at 63 %", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::PathNearSingular, 0, 0.63)}},
    {"move-refused alpha outside the envelope", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::OutsideEnvelope, 0, 1.0, 4)}},
    {"move-refused x outside the envelope at 5 %", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::OutsideEnvelope, 0, 0.05, 1)}},
    {"move-refused across the singular poses", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::WrongSideOfSingularity, 0, 1.0)}},
    {"move-refused leg 4 too fast at 12 %", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::LegSpeed, 4, 0.12)}},
    {"move-refused leg 5 accelerated too hard at 7 %", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::LegAcceleration, 5, 0.07)}},
    {"move-refused too long to plan at 40 %", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::PlanTooLong, 0, 0.4)}},
    {"move-refused start moved", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::StartMoved, 0, 1.0)}},
    {"move-refused limits changed", {EventCode::MoveRefused, checkOf(MotionCheck::Reason::LimitsChanged, 0, 1.0)}},
    {"move-refused stale data", {EventCode::MoveRefused, MotionInhibit{}}},
    {"move-refused no-solution", {EventCode::MoveRefused, MotionInhibit{SolveStatus::NoSolution}}},
    {"move-refused sweep: no such axis", {EventCode::MoveRefused, SweepFault::NoSuchAxis}},
    {"move-refused sweep: the amplitude is not above zero", {EventCode::MoveRefused, SweepFault::Amplitude}},
    {"move-refused sweep: a frequency is below zero", {EventCode::MoveRefused, SweepFault::Frequency}},
    {"move-refused sweep: the duration is not above zero", {EventCode::MoveRefused, SweepFault::Duration}},
    {"settled 2.5", {EventCode::Settled, 2.5}},
    {"not-settled 10", {EventCode::NotSettled, 10.0}},
    {"stop-requested", {EventCode::StopRequested}},
    {"stop-requested disable", {EventCode::StopRequested, Command::Disable}},
    {"stopped-by-controller S", {EventCode::StoppedByController, ControllerState::Stopped}},
    {"stopped-by-controller F", {EventCode::StoppedByController, ControllerState::Fault}},
    {"stopped-by-controller D", {EventCode::StoppedByController, ControllerState::Disabled}},
    {"stopped-by-controller U", {EventCode::StoppedByController, ControllerState::Unreferenced}},
    {"stopped-on-stale-data", {EventCode::StoppedOnStaleData}},
    {"stopped-on-solver singular", {EventCode::StoppedOnSolver, SolveStatus::Singular}},
    {"stopped-on-refusal SET RANGE leg 1", {EventCode::StoppedOnRefusal, DeviceRefusal{DeviceRequest::SetPoint, RefusalReason::Range, "RANGE leg 1"}}},
    {"cleared", {EventCode::Cleared}},
    {"controller-refused HOME STATE", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::Reference, RefusalReason::State, "STATE"}}},
    {"controller-refused PERIOD RANGE 20", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::Period, RefusalReason::Range, "RANGE 20"}}},
    {"controller-refused ENABLE FORMAT", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::Enable, RefusalReason::Format, "FORMAT"}}},
    {"controller-refused HELLO X7", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::Hello, RefusalReason::Other, "X7"}}},
    {"controller-refused IDENT not supported: protocol version 2, not 1", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::Identity, RefusalReason::ProtocolVersion, {}, 2}}},
    {"controller-refused IDENT not supported: 8 legs, not 6", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::Identity, RefusalReason::LegCount, {}, 8}}},
    {"controller-refused IDENT not supported: a field is not of its form, or out of range", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::Identity, RefusalReason::IdentityFields}}},
    {"controller-refused DISABLE STATE no controller is connected", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::Disable, RefusalReason::NotConnected}}},
    {"controller-refused CLEAR STATE the stop is not confirmed yet", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::Clear, RefusalReason::StopUnconfirmed}}},
    {"controller-refused SET RANGE a length is not a positive number", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::SetPoint, RefusalReason::LengthNotPositive}}},
    {"controller-refused X1 X2", {EventCode::ControllerRefused, DeviceRefusal{DeviceRequest::Other, RefusalReason::Other, "X1 X2"}}},
    {"controller-fault 7 X3", {EventCode::ControllerFault, DeviceText{"7 X3"}}},
    {"no-answer HOME", {EventCode::NoAnswer, DeviceRequest::Reference}},
    {"no-answer STOP", {EventCode::NoAnswer, DeviceRequest::Stop}},
    {"no-answer DISABLE", {EventCode::NoAnswer, DeviceRequest::Disable}},
    {"no-answer PERIOD", {EventCode::NoAnswer, DeviceRequest::Period}},
    {"clock-went-back", {EventCode::ClockWentBack}},
    {"command-refused run in stopped", {EventCode::CommandRefused, CommandRefusal{Command::Run, RunState::Stopped, CommandSet{Command::Stop, Command::Disable, Command::Clear}}}},
    {"command-refused jog in disabled", {EventCode::CommandRefused, CommandRefusal{Command::Jog, RunState::Disabled, CommandSet{Command::Stop, Command::Enable, Command::Disable}}}},
    {"command-refused clear in enabled", {EventCode::CommandRefused, CommandRefusal{Command::Clear, RunState::Enabled, CommandSet{Command::Run, Command::Stop, Command::Disable}}}},
    {"command-refused hold in disconnected", {EventCode::CommandRefused, CommandRefusal{Command::Hold, RunState::Disconnected, CommandSet{Command::Stop}}}},
    {"command-refused resume in moving", {EventCode::CommandRefused, CommandRefusal{Command::Resume, RunState::Moving, CommandSet{Command::Stop, Command::Disable, Command::Hold}}}},
    {"report-sample 3", {EventCode::ReportSample, 3.0}},
    {"log-failed 12 rows lost", {EventCode::LogFailed, LogFailure{12, {}}}},
    {"loop-failed X4", {EventCode::LoopFailed, DeviceText{"X4"}}},
    {"preparation-failed reference", {EventCode::PreparationFailed, PreparationFailure{DeviceRequest::Reference, true, {}}}},
    {"preparation-failed enable", {EventCode::PreparationFailed, PreparationFailure{DeviceRequest::Enable, true, {}}}},
    {"preparation-failed HOME was not answered", {EventCode::PreparationFailed, PreparationFailure{DeviceRequest::Reference, false, {}}}},
    {"preparation-failed ENABLE STATE X5", {EventCode::PreparationFailed, PreparationFailure{DeviceRequest::Enable, true, DeviceRefusal{DeviceRequest::Enable, RefusalReason::State, "STATE X5"}}}},
    {"stopped-on-following-error leg 3 off by 25.10 mm, limit 24.0 mm", {EventCode::StoppedOnFollowingError, FollowingError{FollowingError::Cause::SetPoint, 3, 0.0251, 0.024}}},
    {"stopped-on-following-error leg 2 off the path by 25.10 mm, limit 24.0 mm", {EventCode::StoppedOnFollowingError, FollowingError{FollowingError::Cause::Path, 2, 0.0251, 0.024}}},
    {"stopped-on-following-error leg 6 off the path by 5.00 mm, and the path does not go on", {EventCode::StoppedOnFollowingError, FollowingError{FollowingError::Cause::Stalled, 6, 0.005, 0.024}}},
    {"stopped-on-no-echo 300", {EventCode::StoppedOnNoEcho, 300.0}},
    {"stopped-on-limits leg 3 below min_mm", {EventCode::StoppedOnLimits, checkOf(MotionCheck::Reason::LegBelowMin, 3, 1.0)}},
    {"stopped-on-limits near singular", {EventCode::StoppedOnLimits, checkOf(MotionCheck::Reason::NearSingular, 0, 1.0)}},
    {"stopped-on-limits across the singular poses", {EventCode::StoppedOnLimits, checkOf(MotionCheck::Reason::WrongSideOfSingularity, 0, 1.0)}},
    {"stopped-on-new-identity rig", {EventCode::StoppedOnNewIdentity, ControllerIdentity{"rig", {}, {}}}},
    {"stopped-on-new-identity rig, 250 to 301 mm", {EventCode::StoppedOnNewIdentity, ControllerIdentity{"rig", 0.250, 0.301}}},
    {"stopped-after-loss", {EventCode::StoppedAfterLoss}},
    {"disable-unconfirmed", {EventCode::DisableUnconfirmed}},
    {"jog-started", {EventCode::JogStarted}},
    {"jog-limited leg 1 above max_mm", {EventCode::JogLimited, checkOf(MotionCheck::Reason::LegAboveMax, 1, 1.0)}},
    {"solver-changed fsi", {EventCode::SolverChanged, SolverChoice{"fsi", {}}}},
    {"log-space-low 1.93 GB", {EventCode::LogSpaceLow, LogSpace{1930000000, {}}}},
    {"log-space-low 12.00 GB, 42 min", {EventCode::LogSpaceLow, LogSpace{12000000000, 2520.0}}},
    {"log-continued run-2.csv", {EventCode::LogContinued, LogContinuation{LogContinuation::Cause::Full, "run-2.csv"}}},
    {"log-continued run-2.csv: the file before it was deleted", {EventCode::LogContinued, LogContinuation{LogContinuation::Cause::Deleted, "run-2.csv"}}},
    {"log-continued run-3.csv: the file before it was moved or replaced", {EventCode::LogContinued, LogContinuation{LogContinuation::Cause::Moved, "run-3.csv"}}},
    {"log-failed EIO", {EventCode::LogFailed, LogFailure{0, "EIO"}}},
    {"solver-changed mpr3-nr 0123abcd", {EventCode::SolverChanged, SolverChoice{"mpr3-nr", "0123abcd"}}},
};
// clang-format on

} // namespace hexapose
