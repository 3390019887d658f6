// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// What the event list and the log's event column report. Words are stable; the screen translates them.
enum class EventCode {
    Connected,   ///< detail: controller name
    ListenOnly,  ///< an unprotected sender of lengths
    LinkLost,    ///< detail: the system's reason
    DataStale,   ///< no valid measurement for value milliseconds
    DataFresh,   ///< measurements are back
    Referencing, ///< reference asked for
    Referenced,
    Enabled,
    Disabled,
    MoveStarted, ///< value: planned duration, s
    MoveRefused, ///< detail: the check's word form, e.g. "leg 3 above max_mm"
    Settled,     ///< value: s since the move started
    NotSettled,  ///< value: s waited
    StopRequested,
    StoppedByController, ///< detail: controller state letter
    StoppedOnStaleData,
    StoppedOnSolver,  ///< detail: solver status word
    StoppedOnRefusal, ///< detail: what the controller refused
    Cleared,
    ControllerRefused, ///< detail
    ControllerFault,   ///< detail: code and text
    NoAnswer,          ///< detail: the request that got no answer
    ClockWentBack,
    CommandRefused,          ///< detail: command and state, e.g. "run in stopped"
    ReportSample,            ///< value: sample number
    LogFailed,               ///< detail: the system's reason
    LoopFailed,              ///< detail: the error that ended the control loop
    PreparationFailed,       ///< a reference or enable before a move did not come about; detail: which
    StoppedOnFollowingError, ///< a leg is too far from its set-point; detail: leg, gap and limit
    StoppedOnNoEcho,         ///< set-points go unaccepted; value: milliseconds since the first of them
    StoppedOnLimits,         ///< a set-point would leave a stroke; detail: the check's word form
    StoppedOnNewIdentity,    ///< the controller gave another name or other limits; detail: name and limits
    StoppedAfterLoss,        ///< the link is back after a loss in mid-move: a stop was sent
    DisableUnconfirmed,      ///< the closing ended without a word that the drives are off
    JogStarted,
    JogLimited,    ///< a jog came to rest before a limit; detail: the check's word form
    SolverChanged, ///< from this cycle on; detail: its word, then the fingerprint of its model
};

struct Event {
    EventCode code;
    double value = 0.0;
    std::string detail = {};
};

/// "move-started", ...: stable identifier of an event.
std::string_view toWord(EventCode code);
std::optional<EventCode> eventCodeFromWord(std::string_view word);
/// "word", then the value for the codes that carry one, then the detail on the same line: "settled 1.25",
/// "move-refused leg 3 above max_mm".
std::string formatEvent(const Event& event);

/// Whether something ended a motion, or the work, that nobody had asked for.
bool isFault(EventCode code);

/// One field of the log: the events of a cycle, separated by "; ".
std::string formatEvents(const std::vector<Event>& events);
/// The events of such a field. Text that begins with no known word belongs to the detail of the event before
/// it, and is passed over at the beginning.
std::vector<Event> parseEvents(std::string_view field);

} // namespace hexapose
