// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Every pair of state and event, enumerated.

#include "core/machine/machine_state.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <tuple>
#include <vector>

namespace hexapose {
namespace {

constexpr std::array kRunStates{RunState::Disconnected, RunState::Unreferenced, RunState::Disabled,
                                RunState::Enabled,      RunState::Moving,       RunState::Settling,
                                RunState::Stopped,      RunState::Fault};
constexpr std::array kPendings{Pending::None, Pending::Motion, Pending::Clear};

struct Less {
    bool operator()(const MachineState& a, const MachineState& b) const {
        return std::tie(a.run, a.pending) < std::tie(b.run, b.pending);
    }
};
using States = std::set<MachineState, Less>;

std::string nameOf(const MachineState& state) {
    return std::string(toWord(state.run)) + (state.pending == Pending::Motion  ? "+motion"
                                             : state.pending == Pending::Clear ? "+clear"
                                                                               : "");
}

void forEveryPair(const std::function<void(const MachineState&, MachineEvent, const Transition&)>& look) {
    for (const RunState run : kRunStates)
        for (const Pending pending : kPendings)
            for (const MachineEvent event : kMachineEvents) {
                const MachineState state{run, pending};
                SCOPED_TRACE(nameOf(state) + ", event " + std::to_string(static_cast<int>(event)));
                look(state, event, transition(state, event));
            }
}

/// All that can be reached by events that `allowed` lets through.
States reachable(const MachineState& from, const std::function<bool(MachineEvent)>& allowed) {
    States seen{from};
    std::vector<MachineState> open{from};
    while (!open.empty()) {
        const MachineState state = open.back();
        open.pop_back();
        for (const MachineEvent event : kMachineEvents)
            if (allowed(event) && seen.insert(transition(state, event).next).second)
                open.push_back(transition(state, event).next);
    }
    return seen;
}

bool anyMoves(const States& states) {
    for (const MachineState& state : states)
        if (state.run == RunState::Moving)
            return true;
    return false;
}

TEST(MachineState, EveryPairHasADefinedOutcome) {
    int pairs = 0, withRow = 0;
    forEveryPair([&](const MachineState& state, MachineEvent event, const Transition& made) {
        ++pairs;
        withRow += made.defined;
        if (!made.defined) {
            EXPECT_EQ(made.next, state) << "without a row nothing changes";
            EXPECT_EQ(made.action, MachineAction::None);
        }
        const bool report = event == MachineEvent::IsUnreferenced || event == MachineEvent::IsDisabled ||
                            event == MachineEvent::IsEnabled || event == MachineEvent::IsStopped ||
                            event == MachineEvent::HasFault || event == MachineEvent::LinkGone ||
                            event == MachineEvent::Trips || event == MachineEvent::Stop;
        if (report) {
            EXPECT_TRUE(made.defined) << "what the controller says, a stop and a trip are never passed over";
        }
    });
    EXPECT_EQ(pairs, 8 * 3 * static_cast<int>(kMachineEvents.size()));
    EXPECT_GT(withRow, pairs / 3);
}

TEST(MachineState, NothingButRunOrAHeldJogStartsMotion) {
    forEveryPair([](const MachineState& state, MachineEvent event, const Transition& made) {
        if (made.next.run == RunState::Moving && state.run != RunState::Moving) {
            EXPECT_TRUE(event == MachineEvent::Jog ||
                        (event == MachineEvent::PathBegins && state.pending == Pending::Motion));
        }
        if (made.next.pending == Pending::Motion && state.pending != Pending::Motion) {
            EXPECT_EQ(event, MachineEvent::Run);
        }
        if (made.action == MachineAction::BeginJog || made.action == MachineAction::Prepare) {
            EXPECT_TRUE(event == MachineEvent::Jog || event == MachineEvent::Run);
        }
    });
    const States idle = reachable(
        {}, [](MachineEvent event) { return event != MachineEvent::Run && event != MachineEvent::Jog; });
    EXPECT_FALSE(anyMoves(idle));
    EXPECT_TRUE(anyMoves(reachable({}, [](MachineEvent) { return true; }))) << "else this proves nothing";
}

TEST(MachineState, StopAlwaysWins) {
    for (const MachineEvent event : {MachineEvent::Stop, MachineEvent::Trips})
        for (const RunState run : kRunStates)
            for (const Pending pending : kPendings) {
                const Transition made = transition({run, pending}, event);
                SCOPED_TRACE(nameOf({run, pending}));
                EXPECT_EQ(made.action, MachineAction::SendStop);
                EXPECT_EQ(made.next.pending, Pending::None) << "what was asked for is forgotten";
                const bool outranked = run == RunState::Disconnected || run == RunState::Fault;
                EXPECT_EQ(made.next.run, outranked ? run : RunState::Stopped);
            }
}

TEST(MachineState, NoWayFromStoppedOrFaultToMovingWithoutClearAndEnable) {
    for (const RunState run : {RunState::Stopped, RunState::Fault}) {
        // A new link is a new start; a controller may be cleared at its own panel.
        const auto here = [](MachineEvent event) {
            return event != MachineEvent::LinkGone && event != MachineEvent::LeftStop;
        };
        EXPECT_FALSE(
            anyMoves(reachable({run}, [&](MachineEvent e) { return here(e) && e != MachineEvent::Clear; })));
        EXPECT_FALSE(anyMoves(
            reachable({run}, [&](MachineEvent e) { return here(e) && e != MachineEvent::IsEnabled; })));
        EXPECT_TRUE(anyMoves(reachable({run}, here)));
        // However it got out, it is with the drives off: they have to be enabled, and Run or Jog asked for.
        for (const MachineState& state : reachable({run}, [](MachineEvent e) {
                 return e != MachineEvent::IsEnabled && e != MachineEvent::Run && e != MachineEvent::Jog;
             }))
            EXPECT_TRUE(state.run != RunState::Enabled && state.run != RunState::Moving) << nameOf(state);
    }
}

TEST(MachineState, DrivesThatGoOffEndWhatWasGoingOn) {
    for (const RunState run : {RunState::Enabled, RunState::Moving, RunState::Settling})
        for (const MachineEvent event :
             {MachineEvent::IsUnreferenced, MachineEvent::IsDisabled, MachineEvent::IsStopped,
              MachineEvent::HasFault, MachineEvent::LinkGone})
            EXPECT_EQ(transition({run, Pending::Motion}, event).next.pending, Pending::None)
                << nameOf({run, Pending::Motion});
}

TEST(MachineState, RefusesWhatASafeMachineMustRefuse) {
    using E = MachineEvent;
    using S = RunState;
    const std::vector<std::pair<S, E>> rows{
        {S::Disconnected, E::Run}, {S::Disconnected, E::Jog},    {S::Unreferenced, E::Jog},
        {S::Disabled, E::Jog},     {S::Unreferenced, E::Enable}, {S::Moving, E::Run},
        {S::Moving, E::Reference}, {S::Enabled, E::Reference},   {S::Stopped, E::Run},
        {S::Stopped, E::Jog},      {S::Stopped, E::Enable},      {S::Stopped, E::Reference},
        {S::Fault, E::Run},        {S::Fault, E::Enable},        {S::Enabled, E::Clear},
        {S::Moving, E::Clear}};
    for (const auto& [state, event] : rows)
        EXPECT_FALSE(transition({state}, event).defined) << toWord(event) << " in " << toWord(state);
    for (const MachineEvent event : {E::Run, E::Jog, E::Reference})
        EXPECT_FALSE(transition({S::Enabled, Pending::Motion}, event).defined) << "one motion at a time";
}

} // namespace
} // namespace hexapose
