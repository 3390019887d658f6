// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/pose_sequence.h"

#include "core/record/event_codec.h"
#include "tests/support/events.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using Step = PoseSequence::Phase;

Snapshot at(std::chrono::nanoseconds time, std::vector<Event> events = {}) {
    Snapshot snapshot;
    snapshot.time = time;
    snapshot.link = LinkState::Connected;
    snapshot.state = RunState::Disabled;
    snapshot.stale = false;
    snapshot.measuredPose = Pose{};
    snapshot.events = std::move(events);
    return snapshot;
}

/// A cycle of the motion that the sequence asked for last.
Snapshot of(const PoseSequence& sequence, std::chrono::nanoseconds time, std::vector<Event> events = {}) {
    Snapshot snapshot = at(time, std::move(events));
    snapshot.motionId = sequence.id();
    return snapshot;
}

std::vector<Pose> twoTargets() {
    Pose second;
    second.offset.x() = 0.01;
    return {Pose{}, second};
}

TEST(PoseSequence, WaitsForAConnectedPlatformThenVisitsOneAfterTheOther) {
    PoseSequence sequence(twoTargets(), 1s, 70);
    Snapshot notYet = at(0s);
    notYet.stale = true;
    EXPECT_FALSE(sequence.add(notYet));
    EXPECT_EQ(sequence.add(at(1s))->offset.x(), 0.0);
    EXPECT_EQ(sequence.id(), 70U);
    EXPECT_EQ(sequence.accepted(), 0U);
    EXPECT_FALSE(sequence.add(of(sequence, 2s, {{EventCode::MoveStarted}})));
    EXPECT_EQ(sequence.accepted(), 1U);
    EXPECT_FALSE(sequence.add(of(sequence, 3s, {{EventCode::Settled}})));
    EXPECT_EQ(sequence.phase(), Step::Dwelling);
    EXPECT_FALSE(sequence.add(of(sequence, 3900ms)));
    EXPECT_EQ(sequence.add(of(sequence, 4s))->offset.x(), 0.01);
    EXPECT_EQ(sequence.finished(), 1u);
    EXPECT_EQ(sequence.id(), 71U);
    sequence.add(of(sequence, 4500ms, {{EventCode::MoveStarted}}));
    sequence.add(of(sequence, 5s, {{EventCode::Settled}}));
    EXPECT_FALSE(sequence.add(of(sequence, 6s)));
    EXPECT_EQ(sequence.phase(), Step::Done);
    EXPECT_EQ(sequence.finished(), 2u);
}

TEST(PoseSequence, EndsWithTheReasonWhateverStopsTheMove) {
    for (const EventCode code :
         {EventCode::MoveRefused, EventCode::CommandRefused, EventCode::NotSettled, EventCode::StopRequested,
          EventCode::StoppedByController, EventCode::StoppedOnStaleData, EventCode::StoppedOnSolver,
          EventCode::ControllerFault, EventCode::LinkLost, EventCode::LoopFailed,
          EventCode::PreparationFailed, EventCode::StoppedOnFollowingError, EventCode::StoppedOnNoEcho,
          EventCode::StoppedOnLimits, EventCode::StoppedOnNewIdentity, EventCode::StoppedAfterLoss}) {
        PoseSequence sequence(twoTargets(), 1s);
        sequence.add(at(1s));
        const EventData why =
            code == EventCode::CommandRefused
                ? EventData(CommandRefusal{Command::Run, RunState::Moving, {}, sequence.id()})
                : EventData(DeviceText{"why"});
        EXPECT_FALSE(sequence.add(at(2s, {{code, why}})));
        EXPECT_EQ(sequence.phase(), Step::Failed) << toWord(code);
        EXPECT_EQ(sequence.failure()->data.index(), why.index());
        EXPECT_FALSE(sequence.add(at(3s, {{EventCode::Settled}}))) << "a sequence that failed starts nothing";
    }
}

/// By its id, not by the state: which states refuse a Run is the machine table's to say.
TEST(PoseSequence, ItsOwnRunThatIsRefusedEndsItAndNoOther) {
    for (const RunState state :
         {RunState::Disconnected, RunState::Unreferenced, RunState::Disabled, RunState::Enabled,
          RunState::Moving, RunState::Settling, RunState::Stopped, RunState::Fault}) {
        SCOPED_TRACE(toWord(state));
        PoseSequence sequence(twoTargets(), 1s, 70);
        sequence.add(at(1s));
        const auto refused = [&](MotionId id) {
            return Event{EventCode::CommandRefused, CommandRefusal{Command::Run, state, CommandSet{}, id}};
        };
        sequence.add(at(2s, {refused(69), refused(kNoMotion)}));
        EXPECT_EQ(sequence.phase(), Step::Moving);
        sequence.add(at(3s, {refused(70)}));
        EXPECT_EQ(sequence.phase(), Step::Failed);
    }
}

/// A Run that somebody else asks for in mid-move, a jog key, a way-point out of reach: refused, and no more.
TEST(PoseSequence, ARefusalOfAnotherCommandChangesNothing) {
    PoseSequence sequence(twoTargets(), 1s);
    sequence.add(at(1s));
    sequence.add(at(1500ms, {eventFrom("command-refused jog in disabled")}));
    sequence.add(at(1600ms, {eventFrom("command-refused run in disabled")})); // ours is pending
    sequence.add(of(sequence, 2s, {{EventCode::MoveStarted}}));
    EXPECT_EQ(sequence.accepted(), 1U);
    for (const Event& refusal :
         {eventFrom("command-refused run in moving"), eventFrom("command-refused jog in moving"),
          eventFrom("move-refused leg 3 above max_mm"), eventFrom("preparation-failed reference")}) {
        sequence.add(of(sequence, 3s, {refusal}));
        EXPECT_EQ(sequence.phase(), Step::Moving) << formatEvent(refusal);
    }
    sequence.add(of(sequence, 4s, {{EventCode::Settled}}));
    EXPECT_TRUE(sequence.add(of(sequence, 5s)));
}

TEST(PoseSequence, AnotherMotionThatIsAcceptedEndsIt) {
    for (const EventCode code : {EventCode::MoveStarted, EventCode::JogStarted}) {
        for (const bool first : {false, true}) { // before ours was taken, or after it
            PoseSequence sequence(twoTargets(), 1s);
            sequence.add(at(1s));
            if (!first) {
                sequence.add(of(sequence, 2s, {{EventCode::MoveStarted}}));
                sequence.add(of(sequence, 3s, {{EventCode::Settled}}));
            }
            Snapshot another = at(3500ms, {{code}});
            another.motionId = 1234;
            EXPECT_FALSE(sequence.add(another));
            EXPECT_EQ(sequence.phase(), Step::Failed);
            EXPECT_EQ(sequence.failure()->code, code);
        }
    }
}

/// A motion that settles in the moment in which the next Run is asked for is not that Run's.
TEST(PoseSequence, OnlyItsOwnMotionSettles) {
    PoseSequence sequence(twoTargets(), 1s);
    sequence.add(at(1s));
    sequence.add(at(2s, {{EventCode::Settled}}));
    EXPECT_EQ(sequence.phase(), Step::Moving);
    sequence.add(of(sequence, 3s, {{EventCode::Settled}})); // taken, and not begun
    EXPECT_EQ(sequence.phase(), Step::Moving);
}

/// Disable drops a motion that is being prepared, and nothing more is heard of it.
TEST(PoseSequence, ARunThatIsDroppedEndsIt) {
    PoseSequence sequence(twoTargets(), 1s);
    Snapshot free = at(1s);
    free.allowed.insert(Command::Run);
    sequence.add(free);
    sequence.add(free);
    EXPECT_EQ(sequence.phase(), Step::Moving) << "the loop has not seen it yet";
    sequence.add(at(2s)); // pending
    EXPECT_EQ(sequence.phase(), Step::Moving);
    sequence.add(free);
    EXPECT_EQ(sequence.phase(), Step::Failed);
}

TEST(PoseSequence, AnEmptyListIsDoneAtOnce) {
    PoseSequence sequence({}, 1s);
    EXPECT_EQ(sequence.phase(), Step::Done);
    EXPECT_FALSE(sequence.add(at(1s)));
}

} // namespace
} // namespace hexapose
