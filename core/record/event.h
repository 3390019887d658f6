// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/forward_solver.h"
#include "core/motion/motion_check.h"
#include "core/motion/sine_sweep.h"
#include "core/record/command_set.h"
#include "core/record/controller_state.h"
#include "core/record/device_refusal.h"
#include "core/record/motion_id.h"
#include "core/record/port_failure.h"
#include "core/record/run_state.h"

#include <optional>
#include <string>
#include <variant>

namespace hexapose {

/// What the event list and the log's event column report; in brackets the payload.
enum class EventCode {
    Connected,   ///< [DeviceText: the controller's name]
    ListenOnly,  ///< an unprotected sender of lengths
    LinkLost,    ///< [PortFailure]
    DataStale,   ///< [double: ms without a valid measurement]
    DataFresh,   ///< measurements are back
    Referencing, ///< referencing requested
    Referenced,
    Enabled,
    Disabled,
    MoveStarted,         ///< [double: planned duration, s]
    MoveRefused,         ///< [MotionCheck, MotionInhibit or SweepFault]
    Settled,             ///< [double: s since the move started]
    NotSettled,          ///< [double: s waited]
    StopRequested,       ///< [Command::Disable when that requested it]
    StoppedByController, ///< [ControllerState]
    StoppedOnStaleData,
    StoppedOnSolver,  ///< [SolveStatus]
    StoppedOnRefusal, ///< [DeviceRefusal]
    Cleared,
    ControllerRefused, ///< [DeviceRefusal]
    ControllerFault,   ///< [DeviceText: code and text]
    NoAnswer,          ///< [DeviceRequest]
    ClockWentBack,
    CommandRefused,          ///< [CommandRefusal]
    ReportSample,            ///< [double: sample number]
    LogFailed,               ///< [LogFailure]
    LoopFailed,              ///< [DeviceText: the error that ended the control loop]
    PreparationFailed,       ///< a reference or enable before a move did not come about [PreparationFailure]
    StoppedOnFollowingError, ///< [FollowingError]
    StoppedOnNoEcho,         ///< set-points go unaccepted [double: ms since the first of them]
    StoppedOnLimits,         ///< a set-point would leave a stroke, or the measured pose is near a
                             ///< singular one or beyond it [MotionCheck]
    StoppedOnNewIdentity,    ///< the controller gave another name or other limits [ControllerIdentity]
    StoppedAfterLoss,        ///< the link is back after a loss in mid-move: a stop was sent
    DisableUnconfirmed,      ///< the session ended without a confirmation that the drives are off
    JogStarted,
    JogLimited,    ///< a jog came to rest before a limit [MotionCheck]
    SolverChanged, ///< from this cycle on [SolverChoice]
    LogSpaceLow,   ///< the log is being written, but not for long [LogSpace]
    LogContinued,  ///< the log goes on in another file [LogContinuation]
};

/// Text that is not ours: a controller's name or words, an error of the system. Shown as it is.
struct DeviceText {
    std::string text;
    bool operator==(const DeviceText&) const = default;
};

/// Why nothing can move now, whatever is commanded.
struct MotionInhibit {
    std::optional<SolveStatus> solver; ///< the lengths gave no usable pose; empty: the data is stale
    bool operator==(const MotionInhibit&) const = default;
};

/// A command that the machine's state does not allow.
struct CommandRefusal {
    Command command;
    RunState state;
    std::optional<CommandSet> allowed = {}; ///< in its place; empty where that is not known, as from a log
    MotionId id = kNoMotion;                ///< of the Run or Jog that was refused
    bool operator==(const CommandRefusal&) const = default;
};

/// A leg that is not where it should be.
struct FollowingError {
    enum class Cause {
        SetPoint, ///< too far from its set-point
        Path,     ///< too far from where the path has it
        Stalled,  ///< away from the path, which hardly goes on
    };
    Cause cause = Cause::SetPoint;
    int leg = 0;        ///< 1..6
    double gap = 0.0;   ///< m
    double limit = 0.0; ///< m; unused for Stalled
};

/// A reference or enable before a move that did not come about.
struct PreparationFailure {
    DeviceRequest request = DeviceRequest::None;
    bool answered = true;                 ///< false: the request was not answered
    std::optional<DeviceRefusal> refusal; ///< empty while answered: the state did not come in time
    bool operator==(const PreparationFailure&) const = default;
};

/// How a controller identifies itself.
struct ControllerIdentity {
    std::string name;
    std::optional<double> minLength, maxLength; ///< m
    bool operator==(const ControllerIdentity&) const = default;
};

/// The solver of the loop.
struct SolverChoice {
    std::string name;             ///< as on the command line
    std::string modelFingerprint; ///< empty without a model
    bool operator==(const SolverChoice&) const = default;
};

/// What is missing in the log, or why it cannot be written.
struct LogFailure {
    std::uint64_t rowsLost = 0;
    std::string system = {}; ///< the system's words; empty where rows were lost
    bool operator==(const LogFailure&) const = default;
};

/// What is left for the log.
struct LogSpace {
    std::uint64_t freeBytes = 0;
    std::optional<double> secondsLeft; ///< at the present rate; empty while that is not known
    bool operator==(const LogSpace&) const = default;
};

/// Another file of the log, and why.
struct LogContinuation {
    enum class Cause {
        Full,    ///< the file before it has its size
        Deleted, ///< the file before it was deleted; all of it is in this one
        Moved,   ///< the file before it was moved away, replaced or cut by somebody else
    };
    Cause cause = Cause::Full;
    std::string file; ///< its name, without the directory
    bool operator==(const LogContinuation&) const = default;
};

using EventData = std::variant<std::monostate, double, DeviceText, PortFailure, MotionCheck, MotionInhibit,
                               SweepFault, Command, ControllerState, SolveStatus, DeviceRefusal,
                               DeviceRequest, CommandRefusal, FollowingError, PreparationFailure,
                               ControllerIdentity, SolverChoice, LogFailure, LogSpace, LogContinuation>;

/// Something that happened, as values: the log has its words in event_codec.h, the screen has its own.
struct Event {
    EventCode code;
    EventData data = {};

    /// The payload of that type, or null.
    template <typename T>
    const T* get() const {
        return std::get_if<T>(&data);
    }
    double value() const { return get<double>() ? *get<double>() : 0.0; }
};

/// Whether something ended a motion, or the work, that nobody had commanded.
bool isFault(EventCode code);

} // namespace hexapose
