// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/visit_job.h"

#include "core/record/event_codec.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using Reason = VisitFailure::Reason;

Snapshot at(std::chrono::nanoseconds time, RunState state, std::vector<Event> events = {}) {
    Snapshot snapshot;
    snapshot.time = time;
    snapshot.link = LinkState::Connected;
    snapshot.state = state;
    snapshot.stale = false;
    snapshot.fresh = true;
    snapshot.measuredPose = Pose{};
    snapshot.measuredLengths = LegLengths::Constant(0.3);
    snapshot.status = SolveStatus::Converged;
    snapshot.events = std::move(events);
    return snapshot;
}

Snapshot unconnected(std::chrono::nanoseconds time, std::vector<Event> events = {}) {
    Snapshot snapshot;
    snapshot.time = time;
    snapshot.events = std::move(events);
    return snapshot;
}

template <typename Command>
const Command* among(const std::vector<OperatorCommand>& commands) {
    for (const OperatorCommand& command : commands)
        if (const auto* found = std::get_if<Command>(&command))
            return found;
    return nullptr;
}

VisitJob job(const VisitJob::Options& options = {}) {
    return VisitJob({Pose{}}, options);
}

TEST(VisitJob, SetsTheSpeedRunsAndSamples) {
    VisitJob::Options options;
    options.speedOverride = 0.25;
    options.mode = MotionMode::Workspace;
    VisitJob visit = job(options);
    const auto first = visit.add(unconnected(0s));
    ASSERT_NE(among<SpeedCommand>(first), nullptr);
    EXPECT_EQ(among<RunCommand>(first), nullptr);
    const auto second = visit.add(at(1s, RunState::Disabled));
    EXPECT_EQ(among<SpeedCommand>(second), nullptr) << "once";
    ASSERT_NE(among<RunCommand>(second), nullptr);
    EXPECT_EQ(among<RunCommand>(second)->mode, MotionMode::Workspace);
    const MotionId id = among<RunCommand>(second)->id;
    EXPECT_NE(id, kNoMotion);
    Snapshot moving = at(2s, RunState::Moving);
    moving.motionId = id;
    moving.events.push_back({EventCode::MoveStarted, 1.0});
    visit.add(moving);
    for (int k = 0; k <= 13; ++k) {
        Snapshot standing = at(3s + k * 100ms, RunState::Enabled);
        standing.goalPose = Pose{};
        standing.motionId = id;
        if (k == 0)
            standing.events.push_back({EventCode::Settled});
        EXPECT_TRUE(visit.add(standing).empty());
    }
    EXPECT_TRUE(visit.isOver());
    EXPECT_FALSE(visit.failure());
    EXPECT_EQ(visit.visited(), 1U);
    EXPECT_EQ(visit.samples().size(), 1U);
}

TEST(VisitJob, EndsWhenNobodyAnswers) {
    VisitJob visit = job();
    visit.add(unconnected(10s));
    EXPECT_FALSE(visit.isOver());
    EXPECT_TRUE(visit.add(unconnected(10001ms)).empty());
    ASSERT_TRUE(visit.isOver());
    EXPECT_EQ(visit.failure()->reason, Reason::NoAnswer);
}

TEST(VisitJob, ReportsAnAnswerThatIsOfNoUse) {
    VisitJob visit = job();
    visit.add(unconnected(1s, {{EventCode::ControllerRefused}}));
    EXPECT_FALSE(visit.isOver());
    visit.add(unconnected(11s));
    ASSERT_TRUE(visit.isOver());
    EXPECT_EQ(visit.failure()->reason, Reason::UselessAnswer);
    EXPECT_EQ(visit.failure()->event->code, EventCode::ControllerRefused);
}

TEST(VisitJob, EndsOnASenderThatTakesNoCommands) {
    VisitJob visit = job();
    Snapshot listening = at(1s, RunState::Disabled);
    listening.link = LinkState::ListenOnly;
    visit.add(listening);
    ASSERT_TRUE(visit.isOver());
    EXPECT_EQ(visit.failure()->reason, Reason::TakesNoCommands);
}

/// A platform that is singular everywhere, or lengths that no pose has.
TEST(VisitJob, EndsWhenThereIsNoPoseToBeginFrom) {
    VisitJob visit = job();
    Snapshot without = at(5s, RunState::Unreferenced);
    without.measuredPose.reset();
    without.status = SolveStatus::Singular;
    visit.add(without);
    without.time = 15s;
    visit.add(without);
    EXPECT_FALSE(visit.isOver());
    without.time = 15001ms;
    visit.add(without);
    ASSERT_TRUE(visit.isOver());
    EXPECT_EQ(visit.failure()->reason, Reason::NotReady);
    EXPECT_EQ(visit.failure()->status, SolveStatus::Singular);
    EXPECT_EQ(visit.failure()->state, RunState::Unreferenced);
}

TEST(VisitJob, EndsBeforeTheFirstPoseWhenTheLinkOrTheLoopEnds) {
    for (const EventCode code : {EventCode::LinkLost, EventCode::LoopFailed}) {
        VisitJob visit = job();
        visit.add(unconnected(0s, {{code}}));
        ASSERT_TRUE(visit.isOver()) << toWord(code);
        EXPECT_EQ(visit.failure()->event->code, code);
    }
}

TEST(VisitJob, ClearsFirstOnlyWhenAskedTo) {
    VisitJob::Options options;
    EXPECT_NE(among<RunCommand>(job(options).add(at(1s, RunState::Stopped))), nullptr);
    options.clearFirst = true;
    VisitJob visit = job(options);
    EXPECT_NE(among<ClearCommand>(visit.add(at(1s, RunState::Fault))), nullptr);
    EXPECT_TRUE(visit.add(at(2s, RunState::Fault)).empty()) << "once";
    EXPECT_NE(among<RunCommand>(visit.add(at(3s, RunState::Disabled))), nullptr);
    VisitJob stuck = job(options);
    stuck.add(at(1s, RunState::Fault));
    stuck.add(at(12s, RunState::Fault));
    ASSERT_TRUE(stuck.isOver()) << "a fault that cannot be cleared is waited for no longer";
    EXPECT_EQ(stuck.failure()->reason, Reason::NotReady);
}

TEST(VisitJob, SweepsInPlaceOfTheFirstPose) {
    VisitJob::Options options;
    options.sweep = SweepSettings{};
    EXPECT_NE(among<SweepCommand>(job(options).add(at(1s, RunState::Disabled))), nullptr);
}

TEST(VisitJob, AfterTheEndItAsksForNothingAndKeepsWhatGoesWrong) {
    VisitJob visit = job();
    visit.add(at(1s, RunState::Disabled));
    visit.interrupt();
    ASSERT_TRUE(visit.isOver());
    EXPECT_EQ(visit.failure()->reason, Reason::Interrupted);
    EXPECT_TRUE(visit.add(at(2s, RunState::Disabled, {{EventCode::StopRequested}})).empty());
    EXPECT_TRUE(visit.closingFaults().empty()) << "asked for";
    visit.add(at(3s, RunState::Enabled, {{EventCode::DisableUnconfirmed}}));
    ASSERT_EQ(visit.closingFaults().size(), 1U);
    EXPECT_EQ(visit.closingFaults().front().code, EventCode::DisableUnconfirmed);
    EXPECT_EQ(visit.failure()->reason, Reason::Interrupted);
}

} // namespace
} // namespace hexapose
