// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/tracking/joint_motion.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

constexpr double kLegSpeed = 0.04; ///< m/s
constexpr double kLateCycle = 0.030;
const LegLengths kFrom = LegLengths::Constant(0.30);
const LegLengths kTo = LegLengths::Constant(0.32);

MotionGenerator::Cycle cycleOf(double seconds, double speed = 1.0) {
    return {seconds, speed, {}, {}, {}};
}

TEST(JointMotion, GoesToTheEndAndNoCycleMakesALeap) {
    JointMotion law(kFrom, kTo, kLegSpeed);
    LegLengths last = kFrom;
    for (int cycle = 0; !law.finished() && cycle < 1000; ++cycle) {
        const LegLengths next = law.step(cycleOf(cycle == 40 ? kLateCycle : 0.010));
        EXPECT_LE((next - last).cwiseAbs().maxCoeff(), 1.001 * kLegSpeed * kLateCycle) << cycle;
        last = next;
    }
    EXPECT_EQ(last, kTo);
    EXPECT_TRUE(law.inPosition(kTo.array() + 1.9e-4, {}, {2e-4, 0.0}));
    EXPECT_FALSE(law.inPosition(kTo.array() + 2.1e-4, {}, {2e-4, 0.0}));
}

TEST(JointMotion, SpeedZeroHoldsItOnThePathAndAHalfTakesTwiceAsLong) {
    JointMotion whole(kFrom, kTo, kLegSpeed), half(kFrom, kTo, kLegSpeed);
    int cyclesWhole = 0, cyclesHalf = 0;
    while (!whole.finished() && ++cyclesWhole < 10000)
        whole.step(cycleOf(0.010));
    while (!half.finished() && ++cyclesHalf < 10000)
        half.step(cycleOf(0.010, 0.5));
    EXPECT_NEAR(cyclesHalf, 2 * cyclesWhole, 2);

    JointMotion held(kFrom, kTo, kLegSpeed);
    for (int cycle = 0; cycle < 40; ++cycle)
        held.step(cycleOf(0.010));
    for (int cycle = 0; cycle < 30; ++cycle) // comes to rest without a jump
        held.step(cycleOf(0.010, 0.0));
    const LegLengths there = held.step(cycleOf(0.010, 0.0));
    EXPECT_EQ(held.step(cycleOf(0.010, 0.0)), there);
    EXPECT_FALSE(held.finished());
}

} // namespace
} // namespace hexapose
