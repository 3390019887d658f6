// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Every pair of state and event of the table that the loop executes, enumerated.

#include "core/machine/machine_state.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace hexapose {
namespace {

using E = MachineEvent;
using A = MachineAction;
using S = RunState;

constexpr std::array kRunStates{S::Disconnected, S::Unreferenced, S::Disabled, S::Enabled,
                                S::Moving,       S::Settling,     S::Stopped,  S::Fault};
constexpr std::array kPendings{Pending::None, Pending::Plan, Pending::Motion, Pending::Clear,
                               Pending::Cleared};
constexpr std::array kLinks{LinkState::Connecting, LinkState::Connected, LinkState::ListenOnly,
                            LinkState::Lost};
constexpr std::array kReports{E::IsUnreferenced, E::IsDisabled, E::IsEnabled, E::IsStopped, E::HasFault};
constexpr std::array kLatches{Latch::None, Latch::Controller, Latch::Host, Latch::Operator};

auto tied(const MachineState& s) {
    return std::tie(s.run, s.pending, s.latch, s.hasControl, s.held, s.owesStop);
}
struct Less {
    bool operator()(const MachineState& a, const MachineState& b) const { return tied(a) < tied(b); }
};
using States = std::set<MachineState, Less>;

std::string nameOf(const MachineState& state) {
    static const std::vector<std::string> pendings{"", "+plan", "+motion", "+clear", "+cleared"};
    static const std::vector<std::string> latches{"", " (controller's)", " (host's)", " (operator's)"};
    return std::string(toWord(state.run)) + pendings[static_cast<std::size_t>(state.pending)] +
           latches[static_cast<std::size_t>(state.latch)] + (state.hasControl ? " in control" : "") +
           (state.held ? " held" : "") + (state.owesStop ? " owes a stop" : "");
}

std::vector<MachineState> allStates() {
    std::vector<MachineState> all;
    for (const S run : kRunStates)
        for (const Pending pending : kPendings)
            for (const Latch latch : kLatches)
                for (int bits = 0; bits < 8; ++bits)
                    all.push_back({run, pending, latch, (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0});
    return all;
}

void forEveryPair(const std::function<void(const MachineState&, E, const Transition&)>& look) {
    for (const MachineState& state : allStates())
        for (const E event : kMachineEvents) {
            SCOPED_TRACE(nameOf(state) + ", event " + std::to_string(static_cast<int>(event)));
            look(state, event, transition(state, event));
        }
}

/// All that can be reached by events that `allowed` lets through.
States reachable(const MachineState& from, const std::function<bool(E)>& allowed) {
    States seen{from};
    std::vector<MachineState> open{from};
    while (!open.empty()) {
        const MachineState state = open.back();
        open.pop_back();
        for (const E event : kMachineEvents)
            if (allowed(event) && seen.insert(transition(state, event).next).second)
                open.push_back(transition(state, event).next);
    }
    return seen;
}

const States& live() {
    static const States all = reachable({}, [](E) { return true; });
    return all;
}

bool anyMoves(const States& states) {
    return std::any_of(states.begin(), states.end(),
                       [](const MachineState& s) { return s.run == S::Moving; });
}

bool sendsStop(A action) {
    return action == A::EndMotionAndStop || action == A::EndMotionAndStopAndDisable;
}
bool endsMotion(A action) {
    return action == A::EndMotion || action == A::EndMotionAndDisable || sendsStop(action);
}

TEST(MachineState, EveryPairHasADefinedOutcome) {
    std::size_t pairs = 0, withRow = 0;
    forEveryPair([&](const MachineState& state, E event, const Transition& made) {
        ++pairs;
        withRow += made.defined;
        if (!made.defined) {
            EXPECT_EQ(made.next, state) << "without a row nothing changes";
            EXPECT_EQ(made.action, A::None) << "and nothing is sent";
        }
        const bool report = event == E::IsUnreferenced || event == E::IsDisabled || event == E::IsEnabled ||
                            event == E::IsStopped || event == E::HasFault || event == E::LinkGone ||
                            event == E::Trips || event == E::Stop;
        if (report) {
            EXPECT_TRUE(made.defined) << "what the controller says, a stop and a trip are never passed over";
        }
    });
    EXPECT_EQ(pairs, allStates().size() * kMachineEvents.size());
    EXPECT_GT(withRow, pairs / 4);
}

/// Refused means: the same state, the same hold, the same pending motion, nothing sent.
TEST(MachineState, ARefusedCommandChangesNothing) {
    int refused = 0;
    for (const MachineState& state : allStates()) {
        const CommandSet allowed = allowedCommands(state);
        for (const Command command : kCommands) {
            SCOPED_TRACE(nameOf(state) + " " + std::string(toWord(command)));
            const Transition made = transition(state, eventOf(command));
            EXPECT_EQ(allowed.contains(command), made.defined);
            if (made.defined)
                continue;
            ++refused;
            EXPECT_EQ(made.next, state);
            EXPECT_EQ(made.next.held, state.held);
            EXPECT_EQ(made.action, A::None);
        }
    }
    EXPECT_GT(refused, 1000);
}

TEST(MachineState, NothingButRunOrANewPressOfJogStartsMotion) {
    forEveryPair([](const MachineState& state, E event, const Transition& made) {
        if (made.next.run == S::Moving && state.run != S::Moving) {
            EXPECT_TRUE(event == E::Jog || (event == E::PathBegins && state.pending == Pending::Motion));
        }
        if (made.next.pending == Pending::Plan && state.pending != Pending::Plan) {
            EXPECT_EQ(event, E::Run);
        }
        if (made.next.pending == Pending::Motion && state.pending != Pending::Motion) {
            EXPECT_EQ(event, E::PlanReady);
            EXPECT_EQ(state.pending, Pending::Plan);
        }
        if (made.action == A::BeginJog) {
            EXPECT_EQ(event, E::Jog);
        }
        if (made.action == A::Plan) {
            EXPECT_EQ(event, E::Run);
        }
        if (made.action == A::Prepare) {
            EXPECT_EQ(event, E::PlanReady);
        }
        if (made.action == A::BeginPath) {
            EXPECT_EQ(event, E::PathBegins);
        }
    });
    const States idle = reachable({}, [](E event) { return event != E::Run && event != E::Jog; });
    EXPECT_FALSE(anyMoves(idle));
    EXPECT_TRUE(anyMoves(live())) << "else this proves nothing";
}

TEST(MachineState, AHoldEndsByResumeOrWithTheMotionAlone) {
    forEveryPair([](const MachineState& state, E event, const Transition& made) {
        if (!state.held || made.next.held || state.run != S::Moving)
            return;
        EXPECT_TRUE(event == E::Resume || made.next.run != S::Moving) << "no other command lets it go on";
    });
    for (const MachineState& state : live())
        EXPECT_TRUE(!state.held || state.run == S::Moving) << nameOf(state) << ": only what moves is held";
}

TEST(MachineState, EachRequestIsSentForItsOwnReasonAlone) {
    forEveryPair([](const MachineState&, E event, const Transition& made) {
        if (made.action == A::SendReference) {
            EXPECT_EQ(event, E::Reference);
        }
        if (made.action == A::SendEnable) {
            EXPECT_EQ(event, E::Enable);
        }
        if (made.action == A::SendClear) {
            EXPECT_EQ(event, E::Clear);
        }
        if (made.action == A::EndMotionAndDisable) {
            EXPECT_EQ(event, E::Disable);
        }
    });
}

TEST(MachineState, StopAlwaysWins) {
    for (const MachineState& state : allStates())
        for (const E event : {E::Stop, E::Trips}) {
            SCOPED_TRACE(nameOf(state));
            const Transition made = transition(state, event);
            EXPECT_TRUE(sendsStop(made.action));
            EXPECT_EQ(made.next.pending, Pending::None) << "what was asked for is forgotten";
            EXPECT_FALSE(made.next.hasControl);
            EXPECT_FALSE(made.next.held);
            const bool outranked = state.run == S::Disconnected || state.run == S::Fault;
            EXPECT_EQ(made.next.run, outranked ? state.run : S::Stopped);
            if (event == E::Stop) {
                EXPECT_EQ(made.next.latch, Latch::Operator);
            }
        }
}

/// Stop and Disable go out at every end of a motion that nobody asked for, whatever the controller's state
/// says.
TEST(MachineState, AnUnaskedEndOfAMotionStopsAndDisables) {
    int ends = 0;
    for (const MachineState& state : allStates()) {
        if (state.run != S::Moving && state.run != S::Settling)
            continue;
        for (const E event : {E::IsUnreferenced, E::IsDisabled, E::IsStopped, E::HasFault, E::Trips}) {
            SCOPED_TRACE(nameOf(state));
            const Transition made = transition(state, event);
            EXPECT_EQ(made.action, A::EndMotionAndStopAndDisable);
            EXPECT_TRUE(made.next.run == S::Stopped || made.next.run == S::Fault);
            EXPECT_GE(made.next.latch, Latch::Host);
            ++ends;
        }
        // A link that is gone cannot be told; it is once it is back, whatever it says then.
        const Transition gone = transition(state, E::LinkGone);
        EXPECT_TRUE(gone.next.owesStop);
        for (const E event : {E::IsUnreferenced, E::IsDisabled, E::IsEnabled, E::IsStopped, E::HasFault}) {
            const Transition back = transition(gone.next, event);
            EXPECT_EQ(back.action, A::EndMotionAndStopAndDisable) << nameOf(gone.next);
            EXPECT_FALSE(back.next.owesStop);
        }
    }
    EXPECT_GT(ends, 100);
    // A referencing moves the legs, too.
    for (const S run : {S::Unreferenced, S::Disabled, S::Enabled})
        for (const E event : {E::IsStopped, E::HasFault}) {
            const Transition made = transition({run, Pending::Motion, Latch::None, true}, event);
            EXPECT_EQ(made.action, A::EndMotionAndStopAndDisable);
            EXPECT_EQ(made.next.latch, Latch::Host);
        }
    // And no motion ends in another way without being forgotten.
    forEveryPair([](const MachineState& state, E, const Transition& made) {
        const bool was = state.run == S::Moving || state.run == S::Settling;
        const bool is =
            made.next.run == S::Moving || made.next.run == S::Settling || made.next.run == S::Enabled;
        if (was && !is) {
            EXPECT_TRUE(endsMotion(made.action));
        }
    });
}

TEST(MachineState, TheOperatorsStopEndsByTheOperatorsClearAlone) {
    for (const MachineState& state : live()) {
        if (state.latch != Latch::Operator)
            continue;
        for (const MachineState& after : reachable(state, [](E e) { return e != E::Clear; })) {
            // A Clear that was asked for before may still come about.
            if (state.pending == Pending::Clear || state.pending == Pending::Cleared)
                continue;
            EXPECT_EQ(after.latch, Latch::Operator) << nameOf(state) << " -> " << nameOf(after);
            EXPECT_TRUE(after.run == S::Stopped || after.run == S::Fault || after.run == S::Disconnected)
                << nameOf(state) << " -> " << nameOf(after);
        }
    }
    MachineState stopped{S::Stopped, Pending::None, Latch::Operator};
    stopped = transition(stopped, E::Clear).next;
    EXPECT_EQ(transition(stopped, E::IsDisabled).next.run, S::Stopped) << "not before it is confirmed";
    EXPECT_EQ(transition(transition(stopped, E::ClearRefused).next, E::IsDisabled).next.run, S::Stopped);
    stopped = transition(stopped, E::ClearConfirmed).next;
    const MachineState open = transition(stopped, E::IsDisabled).next;
    EXPECT_EQ(open.run, S::Disabled);
    EXPECT_EQ(open.latch, Latch::None);
}

/// Over every link but that to a listen-only sender; nothing else without a controller that accepts commands.
TEST(MachineState, AStopIsAcceptedInEveryStateWhateverBecameOfTheLink) {
    for (const MachineState& state : allStates())
        for (const LinkState link : kLinks)
            for (const Command command : kCommands) {
                const bool row = transition(state, eventOf(command)).defined;
                const bool wanted = link == LinkState::Connected
                                        ? row
                                        : command == Command::Stop && link != LinkState::ListenOnly;
                EXPECT_EQ(allowedCommands(state, link).contains(command), wanted)
                    << toWord(command) << " in " << nameOf(state) << ", link " << static_cast<int>(link);
            }
}

TEST(MachineState, AStopWhileTheLinkIsGoneIsSentWhenItIsBackAndEndsByClearAlone) {
    for (const MachineState& before : live()) {
        const MachineState gone = transition(before, E::LinkGone).next;
        const Transition pressed = transition(gone, E::Stop);
        EXPECT_TRUE(sendsStop(pressed.action)) << nameOf(gone) << ": a port may be there already";
        EXPECT_EQ(pressed.next.run, S::Disconnected);
        EXPECT_EQ(pressed.next.latch, Latch::Operator);
        EXPECT_EQ(pressed.next.owesStop, gone.owesStop);
        const MachineState stillGone = transition(pressed.next, E::LinkGone).next;
        EXPECT_EQ(stillGone, pressed.next) << nameOf(gone);
        for (const E report : kReports) {
            const Transition back = transition(stillGone, report);
            SCOPED_TRACE(nameOf(gone) + " -> " + nameOf(back.next));
            EXPECT_TRUE(sendsStop(back.action)) << "whatever it says";
            EXPECT_EQ(back.next.run, report == E::HasFault ? S::Fault : S::Stopped);
            EXPECT_EQ(back.next.latch, Latch::Operator);
        }
        for (const MachineState& after : reachable(stillGone, [](E e) { return e != E::Clear; }))
            for (const Command command :
                 {Command::Run, Command::Jog, Command::Reference, Command::Enable, Command::Resume})
                EXPECT_FALSE(allowedCommands(after).contains(command))
                    << toWord(command) << " in " << nameOf(after);
    }
}

TEST(MachineState, AControllerThatLeavesItsStopOrFaultOpensItsOwnAlone) {
    for (const auto& [run, left] : {std::pair(S::Fault, E::LeftFault), std::pair(S::Stopped, E::LeftStop)}) {
        for (const Latch latch : {Latch::Host, Latch::Operator}) {
            const MachineState after = transition({run, Pending::None, latch}, left).next;
            EXPECT_EQ(transition(after, E::IsDisabled).next.run, S::Stopped) << nameOf(after);
        }
        const MachineState own = transition({run, Pending::None, Latch::Controller}, left).next;
        EXPECT_EQ(transition(own, E::IsDisabled).next.run, S::Disabled);
    }
}

TEST(MachineState, NoPathFromStoppedOrFaultToMovingWithoutClearAndEnable) {
    for (const S run : {S::Stopped, S::Fault}) {
        const MachineState from{run, Pending::None, Latch::Host};
        // A new link is a new start; a controller may be cleared at its own panel.
        const auto here = [](E event) {
            return event != E::LinkGone && event != E::LeftStop && event != E::LeftFault;
        };
        EXPECT_FALSE(anyMoves(reachable(from, [&](E e) { return here(e) && e != E::Clear; })));
        EXPECT_FALSE(anyMoves(reachable(from, [&](E e) { return here(e) && e != E::IsEnabled; })));
        EXPECT_TRUE(anyMoves(reachable(from, here)));
        // However it got out, it is with the drives off: they have to be enabled, and Run or Jog asked for.
        for (const MachineState& state :
             reachable(from, [](E e) { return e != E::IsEnabled && e != E::Run && e != E::Jog; }))
            EXPECT_TRUE(state.run != S::Enabled && state.run != S::Moving) << nameOf(state);
    }
}

TEST(MachineState, DrivesThatGoOffEndWhatWasGoingOn) {
    for (const S run : {S::Enabled, S::Moving, S::Settling})
        for (const Pending pending : {Pending::Plan, Pending::Motion})
            for (const E event : {E::IsUnreferenced, E::IsDisabled, E::IsStopped, E::HasFault, E::LinkGone}) {
                const Transition made = transition({run, pending, Latch::None, true}, event);
                EXPECT_EQ(made.next.pending, Pending::None) << nameOf({run, pending});
                EXPECT_FALSE(made.next.hasControl);
                EXPECT_TRUE(endsMotion(made.action));
            }
}

TEST(MachineState, RefusesWhatASafeMachineMustRefuse) {
    const std::vector<std::pair<S, Command>> rows{
        {S::Disconnected, Command::Run},    {S::Disconnected, Command::Jog},
        {S::Unreferenced, Command::Jog},    {S::Disabled, Command::Jog},
        {S::Unreferenced, Command::Enable}, {S::Moving, Command::Run},
        {S::Moving, Command::Jog},          {S::Moving, Command::Reference},
        {S::Enabled, Command::Reference},   {S::Stopped, Command::Run},
        {S::Stopped, Command::Jog},         {S::Stopped, Command::Enable},
        {S::Stopped, Command::Reference},   {S::Fault, Command::Run},
        {S::Fault, Command::Enable},        {S::Enabled, Command::Clear},
        {S::Moving, Command::Clear},        {S::Enabled, Command::Hold},
        {S::Enabled, Command::Resume},      {S::Settling, Command::Hold}};
    for (const auto& [state, command] : rows)
        EXPECT_FALSE(allowedCommands({state, Pending::None, Latch::None, true}).contains(command))
            << toWord(command) << " in " << toWord(state);
    for (const Pending pending : {Pending::Plan, Pending::Motion})
        for (const Command command : {Command::Run, Command::Jog, Command::Reference, Command::Enable})
            EXPECT_FALSE(allowedCommands({S::Enabled, pending, Latch::None, true}).contains(command))
                << "one motion at a time";
    EXPECT_FALSE(allowedCommands({S::Enabled}).contains(Command::Jog)) << "nobody has taken control";
}

TEST(MachineState, WhatTheRunningStatesImply) {
    for (const MachineState& state : live()) {
        SCOPED_TRACE(nameOf(state));
        const bool moves = state.run == S::Moving || state.run == S::Settling;
        EXPECT_TRUE(!moves || state.latch == Latch::None) << "nothing moves that is stopped";
        EXPECT_TRUE(!moves || state.hasControl);
        EXPECT_TRUE(!state.owesStop || state.run == S::Disconnected);
        const bool down = state.run == S::Stopped || state.run == S::Fault;
        EXPECT_TRUE(!down || state.latch != Latch::None) << "somebody has to end it";
        EXPECT_TRUE(!down || !state.hasControl) << "no set-point goes out";
        EXPECT_TRUE(down || (state.pending != Pending::Clear && state.pending != Pending::Cleared));
    }
}

} // namespace
} // namespace hexapose
