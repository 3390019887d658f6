// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/report/settled_sample.h"

#include <gtest/gtest.h>

#include <vector>

namespace hexapose {
namespace {

using std::chrono::milliseconds;

const Pose kGoal{{0.012, -0.004, 0.04}, {0.0, 0.0, 0.0872}};
const Pose kOther{{0.0, 0.0, 0.01}, {}};
constexpr double kMeanTolerance = 1e-13; // m, of a sum of a hundred lengths

/// A stream of cycles 10 ms apart.
class SettledSamplerTest : public testing::Test {
protected:
    void feed(RunState state, const Pose& goal, int cycles, bool fresh = true) {
        for (int i = 0; i < cycles; ++i, now += milliseconds(10)) {
            Snapshot s;
            s.time = now;
            s.state = state;
            s.goalPose = goal;
            s.fresh = fresh;
            s.measuredLengths = LegLengths::Constant(length);
            length += step;
            if (const auto sample = sampler.add(s))
                samples.push_back(*sample);
        }
    }
    void moveTo(const Pose& goal) {
        feed(RunState::Moving, goal, 20);
        feed(RunState::Settling, goal, 5);
    }

    SettledSampler sampler;
    std::vector<SettledSample> samples;
    milliseconds now{0};
    double length = 0.3;
    double step = 0.0;
};

TEST_F(SettledSamplerTest, AveragesTheFirstWindowAfterAMove) {
    moveTo(kGoal);
    length = 0.31;
    step = 1e-6;
    const milliseconds settled = now;
    feed(RunState::Enabled, kGoal, 300);
    ASSERT_EQ(samples.size(), 1U) << "one sample a move, however long it stands";
    EXPECT_EQ(samples[0].start, settled);
    EXPECT_EQ(samples[0].measurements, 101) << "both ends of 1 s at 10 ms";
    EXPECT_NEAR(samples[0].meanLengths[0], 0.31 + 50e-6, kMeanTolerance);
    EXPECT_EQ(samples[0].target.toVector(), kGoal.toVector());
    EXPECT_FALSE(sampler.finish().has_value());
}

TEST_F(SettledSamplerTest, NeedsAMoveFirst) {
    feed(RunState::Enabled, kGoal, 300);
    EXPECT_TRUE(samples.empty());
    for (const RunState ended :
         {RunState::Stopped, RunState::Disabled, RunState::Fault, RunState::Disconnected}) {
        moveTo(kGoal);
        feed(ended, kGoal, 1);
        feed(RunState::Enabled, kGoal, 300);
        EXPECT_TRUE(samples.empty()) << toWord(ended);
    }
}

TEST_F(SettledSamplerTest, TakesOneSampleForEachMoveEvenToTheSameGoal) {
    for (int i = 0; i < 3; ++i) {
        moveTo(kGoal);
        feed(RunState::Enabled, kGoal, 110);
    }
    EXPECT_EQ(samples.size(), 3U);
}

TEST_F(SettledSamplerTest, HalfAWindowIsEnoughWhenThePlatformIsSentOn) {
    moveTo(kGoal);
    feed(RunState::Enabled, kGoal, 60);
    feed(RunState::Moving, kOther, 1);
    ASSERT_EQ(samples.size(), 1U);
    EXPECT_EQ(samples[0].measurements, 60);
    feed(RunState::Enabled, kOther, 40);
    feed(RunState::Moving, kGoal, 1);
    EXPECT_EQ(samples.size(), 1U) << "0.4 s is too little";
    feed(RunState::Enabled, kGoal, 55);
    const auto atEnd = sampler.finish();
    ASSERT_TRUE(atEnd.has_value());
    EXPECT_EQ(atEnd->measurements, 55);
    EXPECT_FALSE(sampler.finish().has_value());
}

TEST_F(SettledSamplerTest, AnotherGoalWithoutAMoveIsNoSample) {
    moveTo(kGoal);
    feed(RunState::Enabled, kGoal, 10);
    feed(RunState::Enabled, kOther, 300);
    EXPECT_TRUE(samples.empty());
    Pose throughAFile = kGoal;
    throughAFile.offset.x() += 1e-17;
    moveTo(kGoal);
    feed(RunState::Enabled, kGoal, 50);
    feed(RunState::Enabled, throughAFile, 60);
    EXPECT_EQ(samples.size(), 1U) << "the last bit is no other goal";
}

TEST_F(SettledSamplerTest, OldMeasurementsDoNotCountTwice) {
    moveTo(kGoal);
    feed(RunState::Enabled, kGoal, 60);
    length = 0.5;
    feed(RunState::Enabled, kGoal, 100, false);
    EXPECT_TRUE(samples.empty());
    feed(RunState::Enabled, kGoal, 1);
    ASSERT_EQ(samples.size(), 1U);
    EXPECT_EQ(samples[0].measurements, 60);
    EXPECT_NEAR(samples[0].meanLengths[5], 0.3, kMeanTolerance) << "what came after the window is not in it";
}

} // namespace
} // namespace hexapose
