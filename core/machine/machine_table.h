// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/machine/machine_state.h"

#include <optional>

/// The table itself: see transition().
namespace hexapose::table {

using When = MachineEvent;
using Do = MachineAction;

template <typename... Values>
constexpr unsigned in(Values... values) {
    return ((1U << static_cast<unsigned>(values)) | ...);
}
constexpr unsigned kAny = ~0U;
constexpr unsigned kNo = in(false);
constexpr unsigned kYes = in(true);

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
constexpr unsigned kInMotion = kMoving | kSettling;
constexpr unsigned kDown = kStopped | kFault;

constexpr unsigned kNothing = in(Pending::None);
constexpr unsigned kPlan = in(Pending::Plan);
constexpr unsigned kMotion = in(Pending::Motion);
constexpr unsigned kClear = in(Pending::Clear);
constexpr unsigned kCleared = in(Pending::Cleared);

constexpr unsigned kOperators = in(Latch::Operator);

constexpr unsigned kFaultReport = in(When::HasFault);
/// What a controller reports of its state, but for a fault.
constexpr unsigned kOtherReports =
    in(When::IsUnreferenced, When::IsDisabled, When::IsEnabled, When::IsStopped);

/// What becomes of the latch.
enum class LatchTo { Stays, Opens, OpensUnlessOperators, Controller, Host, Operator };

struct Row {
    unsigned events;
    // From which states.
    unsigned run = kAny;
    unsigned pending = kAny;
    unsigned latch = kAny;
    unsigned control = kAny;
    unsigned held = kAny;
    unsigned owes = kAny;
    // To which; what is not named stays.
    std::optional<RunState> to = {};
    std::optional<Pending> then = {};
    LatchTo latchTo = LatchTo::Stays;
    std::optional<bool> controlTo = {};
    std::optional<bool> heldTo = {};
    std::optional<bool> owesTo = {};
    Do action = Do::None;
};

/// A motion, and the right to command, are over.
constexpr Row ends(Row row) {
    row.then = Pending::None;
    row.controlTo = false;
    row.heldTo = false;
    return row;
}

/// The first row that fits counts.
inline constexpr Row kTable[] = {
    // Stop wins everywhere. It is sent, and remembered, also where nobody has answered yet and while the port
    // is gone: what comes back is stopped, below. A fault outranks it.
    ends({.events = in(When::Stop),
          .run = kDisconnected | kFault,
          .latchTo = LatchTo::Operator,
          .action = Do::EndMotionAndStop}),
    ends({.events = in(When::Stop),
          .to = RunState::Stopped,
          .latchTo = LatchTo::Operator,
          .action = Do::EndMotionAndStop}),
    ends({.events = in(When::Trips), .run = kDisconnected, .action = Do::EndMotionAndStopAndDisable}),
    ends({.events = in(When::Trips),
          .run = kFault,
          .latchTo = LatchTo::Host,
          .action = Do::EndMotionAndStopAndDisable}),
    ends({.events = in(When::Trips),
          .to = RunState::Stopped,
          .latchTo = LatchTo::Host,
          .action = Do::EndMotionAndStopAndDisable}),

    // A link that goes in mid-motion leaves a stop to be sent. The operator's stop outlives the link.
    ends({.events = in(When::LinkGone),
          .run = kInMotion,
          .to = RunState::Disconnected,
          .latchTo = LatchTo::OpensUnlessOperators,
          .owesTo = true,
          .action = Do::EndMotion}),
    ends({.events = in(When::LinkGone),
          .pending = kMotion,
          .to = RunState::Disconnected,
          .latchTo = LatchTo::OpensUnlessOperators,
          .owesTo = true,
          .action = Do::EndMotion}),
    ends({.events = in(When::LinkGone),
          .to = RunState::Disconnected,
          .latchTo = LatchTo::OpensUnlessOperators,
          .action = Do::EndMotion}),

    // The operator's commands. Run plans, then prepares (reference, enable), and moves once the path begins.
    {.events = in(When::Run),
     .run = kUnreferenced | kDisabled | kEnabled | kSettling,
     .pending = kNothing,
     .then = Pending::Plan,
     .action = Do::Plan},
    {.events = in(When::Jog),
     .run = kEnabled | kSettling,
     .pending = kNothing,
     .control = kYes,
     .to = RunState::Moving,
     .heldTo = false,
     .action = Do::BeginJog},
    {.events = in(When::Reference),
     .run = kUnreferenced | kDisabled,
     .pending = kNothing,
     .controlTo = true,
     .action = Do::SendReference},
    {.events = in(When::Enable),
     .run = kDisabled,
     .pending = kNothing,
     .controlTo = true,
     .action = Do::SendEnable},
    // Drives that were on when the link came up are taken over by being asked to go on.
    {.events = in(When::Enable),
     .run = kEnabled,
     .pending = kNothing,
     .control = kNo,
     .controlTo = true,
     .action = Do::SendEnable},
    ends({.events = in(When::Disable),
          .run = kInMotion,
          .to = RunState::Stopped,
          .latchTo = LatchTo::Operator,
          .action = Do::EndMotionAndStopAndDisable}),
    ends({.events = in(When::Disable),
          .run = kUnreferenced | kDisabled | kEnabled,
          .action = Do::EndMotionAndDisable}),
    {.events = in(When::Disable), .run = kDown, .action = Do::EndMotionAndDisable},
    {.events = in(When::Clear), .run = kDown, .then = Pending::Clear, .action = Do::SendClear},
    {.events = in(When::Hold), .run = kMoving, .held = kNo, .heldTo = true},
    {.events = in(When::Resume), .run = kMoving, .held = kYes, .heldTo = false},

    // What is back after a loss in mid-motion, or after the operator's Stop, is stopped first.
    {.events = kFaultReport,
     .run = kDisconnected,
     .owes = kYes,
     .to = RunState::Fault,
     .latchTo = LatchTo::Host,
     .owesTo = false,
     .action = Do::EndMotionAndStopAndDisable},
    {.events = kOtherReports,
     .run = kDisconnected,
     .owes = kYes,
     .to = RunState::Stopped,
     .latchTo = LatchTo::Host,
     .owesTo = false,
     .action = Do::EndMotionAndStopAndDisable},
    {.events = kFaultReport,
     .run = kDisconnected,
     .latch = kOperators,
     .to = RunState::Fault,
     .action = Do::EndMotionAndStop},
    {.events = kOtherReports,
     .run = kDisconnected,
     .latch = kOperators,
     .to = RunState::Stopped,
     .action = Do::EndMotionAndStop},

    // A stop stays until it is cleared, whatever the controller reports meanwhile. Clear counts once the
    // controller confirmed it. A stop of ours, the operator's or the loop's, ends by Clear alone; a
    // controller's
    // own stop or fault may end at the controller, too.
    {.events = in(When::ClearConfirmed, When::LeftStop, When::LeftFault),
     .run = kDown,
     .pending = kClear,
     .then = Pending::Cleared},
    {.events = in(When::ClearRefused), .run = kDown, .pending = kClear, .then = Pending::None},
    {.events = in(When::LeftStop, When::LeftFault),
     .run = kDown,
     .latch = in(Latch::Controller),
     .then = Pending::Cleared},
    {.events = in(When::IsUnreferenced),
     .run = kDown,
     .pending = kCleared,
     .to = RunState::Unreferenced,
     .then = Pending::None,
     .latchTo = LatchTo::Opens},
    {.events = in(When::IsDisabled),
     .run = kDown,
     .pending = kCleared,
     .to = RunState::Disabled,
     .then = Pending::None,
     .latchTo = LatchTo::Opens},
    {.events = kOtherReports, .run = kDown, .to = RunState::Stopped},
    {.events = kFaultReport, .run = kDown, .to = RunState::Fault},

    // Whatever ends a motion that nobody asked to end is stopped and disabled, whatever the controller says;
    // so is a preparation, in which a referencing may move the legs.
    ends({.events = kFaultReport,
          .run = kInMotion,
          .to = RunState::Fault,
          .latchTo = LatchTo::Host,
          .action = Do::EndMotionAndStopAndDisable}),
    ends({.events = in(When::IsStopped, When::IsUnreferenced, When::IsDisabled),
          .run = kInMotion,
          .to = RunState::Stopped,
          .latchTo = LatchTo::Host,
          .action = Do::EndMotionAndStopAndDisable}),
    ends({.events = kFaultReport,
          .pending = kMotion,
          .to = RunState::Fault,
          .latchTo = LatchTo::Host,
          .action = Do::EndMotionAndStopAndDisable}),
    ends({.events = in(When::IsStopped),
          .pending = kMotion,
          .to = RunState::Stopped,
          .latchTo = LatchTo::Host,
          .action = Do::EndMotionAndStopAndDisable}),

    // At rest the controller's word is the state. Drives that go off end what was asked for.
    ends({.events = in(When::HasFault),
          .to = RunState::Fault,
          .latchTo = LatchTo::Controller,
          .action = Do::EndMotion}),
    ends({.events = in(When::IsStopped),
          .to = RunState::Stopped,
          .latchTo = LatchTo::Controller,
          .action = Do::EndMotion}),
    {.events = in(When::IsUnreferenced), .run = kOff, .to = RunState::Unreferenced},
    {.events = in(When::IsDisabled), .run = kOff, .to = RunState::Disabled},
    ends({.events = in(When::IsUnreferenced),
          .run = kEnabled,
          .to = RunState::Unreferenced,
          .action = Do::EndMotion}),
    ends(
        {.events = in(When::IsDisabled), .run = kEnabled, .to = RunState::Disabled, .action = Do::EndMotion}),
    {.events = in(When::IsEnabled), .run = kOff, .to = RunState::Enabled},
    {.events = in(When::IsEnabled), .run = kOn},

    // A motion that was asked for.
    {.events = in(When::PlanReady),
     .run = kUnreferenced | kDisabled | kEnabled | kSettling,
     .pending = kPlan,
     .then = Pending::Motion,
     .controlTo = true,
     .action = Do::Prepare},
    {.events = in(When::PlanRefused), .pending = kPlan, .then = Pending::None},
    {.events = in(When::PathBegins),
     .run = kEnabled | kSettling,
     .pending = kMotion,
     .to = RunState::Moving,
     .then = Pending::None,
     .heldTo = false,
     .action = Do::BeginPath},
    {.events = in(When::MotionDropped), .pending = kMotion, .then = Pending::None, .action = Do::EndMotion},
    {.events = in(When::PathEnds), .run = kMoving, .to = RunState::Settling, .heldTo = false},
    {.events = in(When::Settles), .run = kSettling, .to = RunState::Enabled},
};

} // namespace hexapose::table
