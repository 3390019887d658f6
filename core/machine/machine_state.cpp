// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/machine_state.h"

#include <optional>

namespace hexapose {

namespace {

using When = MachineEvent;
using Do = MachineAction;

constexpr unsigned in(RunState state) {
    return 1U << static_cast<unsigned>(state);
}
constexpr unsigned in(Pending pending) {
    return 1U << static_cast<unsigned>(pending);
}

constexpr unsigned kDisconnected = in(RunState::Disconnected);
constexpr unsigned kUnreferenced = in(RunState::Unreferenced);
constexpr unsigned kDisabled = in(RunState::Disabled);
constexpr unsigned kEnabled = in(RunState::Enabled);
constexpr unsigned kMoving = in(RunState::Moving);
constexpr unsigned kSettling = in(RunState::Settling);
constexpr unsigned kStopped = in(RunState::Stopped);
constexpr unsigned kFault = in(RunState::Fault);
constexpr unsigned kOff = kDisconnected | kUnreferenced | kDisabled; ///< drives off, or not known
constexpr unsigned kOn = kEnabled | kMoving | kSettling;
constexpr unsigned kDown = kStopped | kFault;
constexpr unsigned kEvery = kOff | kOn | kDown;

constexpr unsigned kNothing = in(Pending::None);
constexpr unsigned kMotion = in(Pending::Motion);
constexpr unsigned kClear = in(Pending::Clear);
constexpr unsigned kAnything = kNothing | kMotion | kClear;

constexpr std::nullopt_t kStays = std::nullopt;

struct Row {
    When event;
    unsigned from;    ///< states
    unsigned pending; ///< of what is pending
    std::optional<RunState> to;
    std::optional<Pending> then;
    Do action;
};

/// The first row that fits counts.
constexpr Row kTable[] = {
    // Stop wins everywhere. Where nobody is connected it is sent all the same; a fault outranks it.
    {When::Stop, kDisconnected | kFault, kAnything, kStays, Pending::None, Do::SendStop},
    {When::Stop, kEvery, kAnything, RunState::Stopped, Pending::None, Do::SendStop},
    {When::Trips, kDisconnected | kFault, kAnything, kStays, Pending::None, Do::SendStop},
    {When::Trips, kEvery, kAnything, RunState::Stopped, Pending::None, Do::SendStop},
    {When::LinkGone, kEvery, kAnything, RunState::Disconnected, Pending::None, Do::None},

    // The operator's wishes. Run prepares first (reference, enable) and moves once the path begins.
    {When::Run, kUnreferenced | kDisabled | kEnabled | kSettling, kNothing, kStays, Pending::Motion,
     Do::Prepare},
    {When::Jog, kEnabled | kSettling, kNothing, RunState::Moving, Pending::None, Do::BeginJog},
    {When::Reference, kUnreferenced | kDisabled, kNothing, kStays, kStays, Do::SendReference},
    {When::Enable, kDisabled, kNothing, kStays, kStays, Do::SendEnable},
    {When::Disable, kMoving | kSettling, kAnything, RunState::Stopped, Pending::None, Do::SendStop},
    {When::Disable, kUnreferenced | kDisabled | kEnabled, kAnything, kStays, Pending::None, Do::SendDisable},
    {When::Disable, kDown, kAnything, kStays, kStays, Do::SendDisable},
    {When::Clear, kDown, kAnything, kStays, Pending::Clear, Do::SendClear},

    // A stop stays until it is cleared, whatever the controller reports meanwhile.
    {When::LeftStop, kDown, kAnything, kStays, Pending::Clear, Do::None},
    {When::IsUnreferenced, kDown, kClear, RunState::Unreferenced, Pending::None, Do::None},
    {When::IsDisabled, kDown, kClear, RunState::Disabled, Pending::None, Do::None},
    {When::IsUnreferenced, kFault, kAnything, RunState::Stopped, kStays, Do::None},
    {When::IsDisabled, kFault, kAnything, RunState::Stopped, kStays, Do::None},
    {When::IsEnabled, kFault, kAnything, RunState::Stopped, kStays, Do::None},
    {When::IsStopped, kFault, kAnything, RunState::Stopped, kStays, Do::None},
    {When::IsUnreferenced, kStopped, kAnything, kStays, kStays, Do::None},
    {When::IsDisabled, kStopped, kAnything, kStays, kStays, Do::None},
    {When::IsEnabled, kStopped, kAnything, kStays, kStays, Do::None},
    {When::IsStopped, kStopped, kAnything, kStays, kStays, Do::None},
    {When::IsStopped, kEvery, kAnything, RunState::Stopped, Pending::None, Do::None},
    {When::HasFault, kFault, kAnything, kStays, kStays, Do::None},
    {When::HasFault, kEvery, kAnything, RunState::Fault, Pending::None, Do::None},

    // Otherwise its word is the state. Drives that go off end what was going on.
    {When::IsUnreferenced, kOff, kAnything, RunState::Unreferenced, kStays, Do::None},
    {When::IsDisabled, kOff, kAnything, RunState::Disabled, kStays, Do::None},
    {When::IsUnreferenced, kOn, kAnything, RunState::Unreferenced, Pending::None, Do::None},
    {When::IsDisabled, kOn, kAnything, RunState::Disabled, Pending::None, Do::None},
    {When::IsEnabled, kOff, kAnything, RunState::Enabled, kStays, Do::None},
    {When::IsEnabled, kOn, kAnything, kStays, kStays, Do::None},

    // A motion that was asked for.
    {When::PathBegins, kEnabled | kSettling, kMotion, RunState::Moving, Pending::None, Do::None},
    {When::MotionDropped, kEvery, kMotion, kStays, Pending::None, Do::None},
    {When::PathEnds, kMoving, kAnything, RunState::Settling, kStays, Do::None},
    {When::Settles, kSettling, kAnything, RunState::Enabled, kStays, Do::None},
};

} // namespace

bool isCommand(MachineEvent event) {
    return !toWord(event).empty();
}

std::string_view toWord(MachineEvent event) {
    switch (event) {
    case MachineEvent::Run:
        return "run";
    case MachineEvent::Jog:
        return "jog";
    case MachineEvent::Stop:
        return "stop";
    case MachineEvent::Reference:
        return "reference";
    case MachineEvent::Enable:
        return "enable";
    case MachineEvent::Disable:
        return "disable";
    case MachineEvent::Clear:
        return "clear";
    default:
        return {};
    }
}

Transition transition(const MachineState& state, MachineEvent event) {
    for (const Row& row : kTable) {
        if (row.event != event || !(row.from & in(state.run)) || !(row.pending & in(state.pending)))
            continue;
        return {{row.to.value_or(state.run), row.then.value_or(state.pending)}, row.action, true};
    }
    return {state, MachineAction::None, false};
}

} // namespace hexapose
