// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/command_set.h"
#include "core/record/controller_state.h"
#include "core/record/link_state.h"
#include "core/record/run_state.h"

#include <array>

namespace hexapose {

/// What can happen to the machine.
enum class MachineEvent {
    // The operator asks.
    Run,
    Jog, ///< a new press of a jog button
    Stop,
    Reference,
    Enable,
    Disable,
    Clear,
    Hold,
    Resume,
    // The controller reports.
    IsUnreferenced,
    IsDisabled,
    IsEnabled,
    IsStopped,
    HasFault,
    LeftStop,       ///< its own state was Stopped and is not any more
    LeftFault,      ///< its own state was Fault and is not any more
    ClearConfirmed, ///< it accepted Clear
    ClearRefused,
    LinkGone,
    // The loop finds.
    PlanReady,     ///< the motion that was asked for is planned, and can be done
    PlanRefused,   ///< it cannot
    PathBegins,    ///< the drives are on, and the plan still holds
    MotionDropped, ///< what was asked for will not come about
    PathEnds,
    Settles,
    Trips, ///< a limit, stale data, the solver, the controller's identity: whatever must end a motion
};
inline constexpr std::array kMachineEvents{MachineEvent::Run,
                                           MachineEvent::Jog,
                                           MachineEvent::Stop,
                                           MachineEvent::Reference,
                                           MachineEvent::Enable,
                                           MachineEvent::Disable,
                                           MachineEvent::Clear,
                                           MachineEvent::Hold,
                                           MachineEvent::Resume,
                                           MachineEvent::IsUnreferenced,
                                           MachineEvent::IsDisabled,
                                           MachineEvent::IsEnabled,
                                           MachineEvent::IsStopped,
                                           MachineEvent::HasFault,
                                           MachineEvent::LeftStop,
                                           MachineEvent::LeftFault,
                                           MachineEvent::ClearConfirmed,
                                           MachineEvent::ClearRefused,
                                           MachineEvent::LinkGone,
                                           MachineEvent::PlanReady,
                                           MachineEvent::PlanRefused,
                                           MachineEvent::PathBegins,
                                           MachineEvent::MotionDropped,
                                           MachineEvent::PathEnds,
                                           MachineEvent::Settles,
                                           MachineEvent::Trips};

MachineEvent eventOf(Command command);
/// LinkGone for Unknown.
MachineEvent eventOf(ControllerState state);

/// What was asked for and has not come about yet.
enum class Pending {
    None,
    Plan,    ///< a motion waits for its plan
    Motion,  ///< a planned motion waits for the drives
    Clear,   ///< Clear was asked for and is not confirmed
    Cleared, ///< it is confirmed; the controller's state has to follow
};

/// Who has to end a stop: the higher outranks the lower.
enum class Latch {
    None,
    Controller, ///< its own stop or fault: it may end it, too
    Host,       ///< the loop stopped the machine: Clear ends it, or a new link
    Operator,   ///< the operator pressed Stop: Clear alone ends it, whatever happens to the link
};

/// All that decides what an event leads to.
struct MachineState {
    RunState run = RunState::Disconnected;
    Pending pending = Pending::None;
    Latch latch = Latch::None;
    bool hasControl = false; ///< the operator asked for something on this link: set-points may go out
    bool held = false;       ///< the motion is held on its path
    bool owesStop = false;   ///< the link was lost in mid-motion: a stop goes out when it is back
    bool operator==(const MachineState&) const = default;
};

/// What the loop does about an event, in the same cycle.
enum class MachineAction {
    None,
    Plan,
    Prepare, ///< reference and enable, as far as that is due
    BeginPath,
    BeginJog,
    SendReference,
    SendEnable,
    SendClear,
    EndMotion,                  ///< forget the motion, send nothing
    EndMotionAndDisable,        ///< forget the motion, send Disable
    EndMotionAndStop,           ///< an asked end
    EndMotionAndStopAndDisable, ///< an unasked end: Stop, then Disable in the next cycle
};
inline constexpr std::array kMachineActions{MachineAction::None,
                                            MachineAction::Plan,
                                            MachineAction::Prepare,
                                            MachineAction::BeginPath,
                                            MachineAction::BeginJog,
                                            MachineAction::SendReference,
                                            MachineAction::SendEnable,
                                            MachineAction::SendClear,
                                            MachineAction::EndMotion,
                                            MachineAction::EndMotionAndDisable,
                                            MachineAction::EndMotionAndStop,
                                            MachineAction::EndMotionAndStopAndDisable};

struct Transition {
    MachineState next;
    MachineAction action = MachineAction::None;
    bool defined = false; ///< there is a row for it; a command without one is refused, a report ignored
};

/// The whole of the machine's behaviour, from one table. Every pair of state and event has an outcome; where
/// the table has no row the state stays and nothing is done.
Transition transition(const MachineState& state, MachineEvent event);

/// The commands that have a row in this state and are worth asking for over this link: all of them where a
/// controller accepts commands. Stop counts also before it has identified itself and while the port is gone:
/// it is sent as soon as it can be. A listen-only sender accepts nothing.
CommandSet allowedCommands(const MachineState& state, LinkState link = LinkState::Connected);

} // namespace hexapose
