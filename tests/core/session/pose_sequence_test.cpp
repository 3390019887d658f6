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

std::vector<Pose> twoTargets() {
    Pose second;
    second.offset.x() = 0.01;
    return {Pose{}, second};
}

TEST(PoseSequence, WaitsForAConnectedPlatformThenVisitsOneAfterTheOther) {
    PoseSequence sequence(twoTargets(), 1s);
    Snapshot notYet = at(0s);
    notYet.stale = true;
    EXPECT_FALSE(sequence.add(notYet));
    EXPECT_EQ(sequence.add(at(1s))->offset.x(), 0.0);
    EXPECT_FALSE(sequence.add(at(2s, {{EventCode::MoveStarted}})));
    EXPECT_FALSE(sequence.add(at(3s, {{EventCode::Settled}})));
    EXPECT_EQ(sequence.phase(), Step::Dwelling);
    EXPECT_FALSE(sequence.add(at(3900ms)));
    EXPECT_EQ(sequence.add(at(4s))->offset.x(), 0.01);
    EXPECT_EQ(sequence.finished(), 1u);
    sequence.add(at(4500ms, {{EventCode::MoveStarted}}));
    sequence.add(at(5s, {{EventCode::Settled}}));
    EXPECT_FALSE(sequence.add(at(6s)));
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
        const EventData why = code == EventCode::CommandRefused
                                  ? EventData(CommandRefusal{Command::Run, RunState::Moving})
                                  : EventData(DeviceText{"why"});
        EXPECT_FALSE(sequence.add(at(2s, {{code, why}})));
        EXPECT_EQ(sequence.phase(), Step::Failed) << toWord(code);
        EXPECT_EQ(sequence.failure()->data.index(), why.index());
        EXPECT_FALSE(sequence.add(at(3s, {{EventCode::Settled}}))) << "a sequence that failed starts nothing";
    }
}

/// A Run that somebody else asks for in mid-move, a jog key, a way-point out of reach: refused, and no more.
TEST(PoseSequence, ARefusalOfAnotherCommandChangesNothing) {
    PoseSequence sequence(twoTargets(), 1s);
    sequence.add(at(1s));
    sequence.add(at(1500ms, {eventFrom("command-refused jog in disabled")}));
    sequence.add(at(2s, {{EventCode::MoveStarted}}));
    EXPECT_EQ(sequence.begun(), 1U);
    for (const Event& refusal :
         {eventFrom("command-refused run in moving"), eventFrom("command-refused jog in moving"),
          eventFrom("move-refused leg 3 above max_mm"), eventFrom("preparation-failed reference")}) {
        sequence.add(at(3s, {refusal}));
        EXPECT_EQ(sequence.phase(), Step::Moving) << formatEvent(refusal);
    }
    sequence.add(at(4s, {{EventCode::Settled}}));
    EXPECT_TRUE(sequence.add(at(5s)));
}

TEST(PoseSequence, AnotherMotionThatBeginsEndsIt) {
    for (const EventCode code : {EventCode::MoveStarted, EventCode::JogStarted}) {
        PoseSequence sequence(twoTargets(), 1s);
        sequence.add(at(1s));
        sequence.add(at(2s, {{EventCode::MoveStarted}}));
        sequence.add(at(3s, {{EventCode::Settled}}));
        EXPECT_FALSE(sequence.add(at(3500ms, {{code}})));
        EXPECT_EQ(sequence.phase(), Step::Failed);
        EXPECT_EQ(sequence.failure()->code, code);
    }
}

TEST(PoseSequence, AnEmptyListIsDoneAtOnce) {
    PoseSequence sequence({}, 1s);
    EXPECT_EQ(sequence.phase(), Step::Done);
    EXPECT_FALSE(sequence.add(at(1s)));
}

} // namespace
} // namespace hexapose
