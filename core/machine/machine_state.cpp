// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/machine_state.h"

#include "core/machine/machine_table.h"

#include <algorithm>

namespace hexapose {

namespace {

using table::in;
using table::LatchTo;
using table::Row;

bool fits(const Row& row, const MachineState& state, MachineEvent event) {
    return (row.events & in(event)) && (row.run & in(state.run)) && (row.pending & in(state.pending)) &&
           (row.latch & in(state.latch)) && (row.control & in(state.hasControl)) &&
           (row.held & in(state.held)) && (row.owes & in(state.owesStop));
}

Latch latchAfter(LatchTo to, Latch before) {
    switch (to) {
    case LatchTo::Stays:
        return before;
    case LatchTo::Opens:
        return Latch::None;
    case LatchTo::OpensUnlessOperators:
        return before == Latch::Operator ? before : Latch::None;
    case LatchTo::Controller:
        return std::max(before, Latch::Controller);
    case LatchTo::Host:
        return std::max(before, Latch::Host);
    case LatchTo::Operator:
        return Latch::Operator;
    }
    return before;
}

} // namespace

MachineEvent eventOf(Command command) {
    switch (command) {
    case Command::Run:
        return MachineEvent::Run;
    case Command::Jog:
        return MachineEvent::Jog;
    case Command::Stop:
        return MachineEvent::Stop;
    case Command::Reference:
        return MachineEvent::Reference;
    case Command::Enable:
        return MachineEvent::Enable;
    case Command::Disable:
        return MachineEvent::Disable;
    case Command::Clear:
        return MachineEvent::Clear;
    case Command::Hold:
        return MachineEvent::Hold;
    case Command::Resume:
        break;
    }
    return MachineEvent::Resume;
}

MachineEvent eventOf(ControllerState state) {
    switch (state) {
    case ControllerState::Unreferenced:
        return MachineEvent::IsUnreferenced;
    case ControllerState::Disabled:
        return MachineEvent::IsDisabled;
    case ControllerState::Enabled:
        return MachineEvent::IsEnabled;
    case ControllerState::Stopped:
        return MachineEvent::IsStopped;
    case ControllerState::Fault:
        return MachineEvent::HasFault;
    case ControllerState::Unknown:
        break;
    }
    return MachineEvent::LinkGone;
}

Transition transition(const MachineState& state, MachineEvent event) {
    for (const Row& row : table::kTable) {
        if (!fits(row, state, event))
            continue;
        MachineState next = state;
        next.run = row.to.value_or(state.run);
        next.pending = row.then.value_or(state.pending);
        next.latch = latchAfter(row.latchTo, state.latch);
        next.hasControl = row.controlTo.value_or(state.hasControl);
        next.held = row.heldTo.value_or(state.held);
        next.owesStop = row.owesTo.value_or(state.owesStop);
        return {next, row.action, true};
    }
    return {state, MachineAction::None, false};
}

CommandSet allowedCommands(const MachineState& state, LinkState link) {
    const auto passes = [link](Command command) {
        return link == LinkState::Connected || (command == Command::Stop && link != LinkState::ListenOnly);
    };
    CommandSet allowed;
    for (const Command command : kCommands)
        if (passes(command) && transition(state, eventOf(command)).defined)
            allowed.insert(command);
    return allowed;
}

} // namespace hexapose
