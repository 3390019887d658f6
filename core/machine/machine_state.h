// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/run_state.h"

#include <array>
#include <string_view>

namespace hexapose {

/// What can happen to the machine.
enum class MachineEvent {
    // The operator asks.
    Run,
    Jog, ///< a jog button is held, said again and again
    Stop,
    Reference,
    Enable,
    Disable,
    Clear,
    // The controller reports.
    IsUnreferenced,
    IsDisabled,
    IsEnabled,
    IsStopped,
    HasFault,
    LeftStop, ///< it was in a stop or fault of its own, and is not any more
    LinkGone,
    // The loop finds.
    PathBegins,    ///< the drives are on, and the path was judged once more
    MotionDropped, ///< what was asked for will not come about
    PathEnds,
    Settles,
    Trips, ///< a limit, stale data, the solver, the link: whatever must end a motion
};
inline constexpr std::array kMachineEvents{
    MachineEvent::Run,        MachineEvent::Jog,       MachineEvent::Stop,       MachineEvent::Reference,
    MachineEvent::Enable,     MachineEvent::Disable,   MachineEvent::Clear,      MachineEvent::IsUnreferenced,
    MachineEvent::IsDisabled, MachineEvent::IsEnabled, MachineEvent::IsStopped,  MachineEvent::HasFault,
    MachineEvent::LeftStop,   MachineEvent::LinkGone,  MachineEvent::PathBegins, MachineEvent::MotionDropped,
    MachineEvent::PathEnds,   MachineEvent::Settles,   MachineEvent::Trips};

/// Whether an event is a wish of the operator, which can be refused.
bool isCommand(MachineEvent event);
/// "run", "jog", ...: as refusals name it; empty for what is no command.
std::string_view toWord(MachineEvent event);

/// What was asked for and has not come about yet.
enum class Pending { None, Motion, Clear };

/// State of the machine with what is pending: all that decides what an event leads to.
struct MachineState {
    RunState run = RunState::Disconnected;
    Pending pending = Pending::None;
    bool operator==(const MachineState&) const = default;
};

/// What the loop has to do about an event.
enum class MachineAction {
    None,
    Prepare,
    BeginJog,
    SendStop,
    SendReference,
    SendEnable,
    SendDisable,
    SendClear
};

struct Transition {
    MachineState next;
    MachineAction action = MachineAction::None;
    bool defined = false; ///< there is a row for it; a command without one is refused, a report ignored
};

/// The whole of the machine's behaviour, from one table. Every pair of state and event has an outcome; where
/// the table has no row the state stays.
Transition transition(const MachineState& state, MachineEvent event);

} // namespace hexapose
