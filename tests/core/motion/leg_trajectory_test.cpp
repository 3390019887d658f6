// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/leg_trajectory.h"

#include <gtest/gtest.h>

#include <chrono>

namespace hexapose {
namespace {

using namespace std::chrono_literals;

constexpr double kSpeedSlack = 1e-3; // of the allowed speed: differences over a step of 0.1 ms
constexpr double kExact = 0.0;

LegLengths ramp() {
    LegLengths lengths;
    lengths << 0.30, 0.31, 0.29, 0.305, 0.27, 0.33;
    return lengths;
}

TEST(LegTrajectory, StartsAndEndsExactlyAndStaysThere) {
    const LegLengths from = LegLengths::Constant(0.3);
    const LegTrajectory path(from, ramp(), 0.04);
    EXPECT_EQ((path.at(-1s) - from).norm(), kExact);
    EXPECT_EQ((path.at(0s) - from).norm(), kExact);
    EXPECT_EQ((path.at(path.duration()) - ramp()).norm(), kExact);
    EXPECT_EQ((path.at(path.duration() + 10s) - ramp()).norm(), kExact);
}

TEST(LegTrajectory, ATinyMoveTakesItsTimeToo) {
    const LegLengths from = LegLengths::Constant(0.3);
    const LegTrajectory path(from, from + LegLengths::Constant(1e-6), 0.04);
    EXPECT_GE(path.duration(), 200ms);
}

TEST(LegTrajectory, TheFastestLegReachesTheAllowedSpeedAndNoLegExceedsIt) {
    const double speed = 0.04;
    const LegTrajectory path(LegLengths::Constant(0.3), ramp(), speed);
    const auto step = 100us;
    double maxSpeed = 0.0;
    for (std::chrono::nanoseconds t = 0ns; t < path.duration(); t += step)
        maxSpeed = std::max(maxSpeed, (path.at(t + step) - path.at(t)).cwiseAbs().maxCoeff() / 1e-4);
    EXPECT_NEAR(maxSpeed, speed, kSpeedSlack * speed);
}

TEST(LegTrajectory, StartsAndEndsAtRest) {
    const LegTrajectory path(LegLengths::Constant(0.3), ramp(), 0.04);
    // The minimum-jerk profile leaves as the third power of time: 1 % of the way in time is 1e-5 of the way.
    EXPECT_LT(path.fractionAt(path.duration() / 100), 1.1e-5);
    EXPECT_GT(path.fractionAt(path.duration() - path.duration() / 100), 1.0 - 1.1e-5);
    EXPECT_NEAR(path.fractionAt(path.duration() / 2), 0.5, 1e-6);
}

TEST(LegTrajectory, AllLegsAreTheSamePartOfTheWayAtAnyTime) {
    const LegLengths from = LegLengths::Constant(0.3);
    const LegTrajectory path(from, ramp(), 0.04);
    for (int k = 1; k < 10; ++k) {
        const auto time = k * path.duration() / 10;
        const LegLengths expected = from + path.fractionAt(time) * (ramp() - from);
        EXPECT_LT((path.at(time) - expected).norm(), 1e-15);
    }
}

TEST(LegTrajectory, NoWayTakesAShortTimeAndMovesNothing) {
    const LegTrajectory path(ramp(), ramp(), 0.04);
    EXPECT_GT(path.duration(), 0ns);
    EXPECT_EQ((path.at(path.duration() / 3) - ramp()).norm(), kExact);
}

} // namespace
} // namespace hexapose
