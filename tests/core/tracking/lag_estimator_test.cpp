// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/tracking/lag_estimator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hexapose {
namespace {

constexpr double kCycle = 0.01;      ///< s
constexpr double kLag = 0.12;        ///< s, of the legs here
constexpr double kLearned = 4e-3;    ///< s: what is left of an error once it is known
constexpr double kAmplitude = 0.010; ///< m, of a swing of 2 s

/// Legs that swing `kLag` behind their set-point, from `begin` on.
void swing(LegLagEstimator& estimator, double seconds, double begin) {
    const double w = M_PI;
    const auto at = [&](double t) { return LegLengths::Constant(begin + kAmplitude * std::sin(w * t)); };
    for (double t = kCycle; t < seconds; t += kCycle) {
        // The set-point in force lies in the middle of the cycle that the measurement ends.
        estimator.add(at(t - 0.5 * kCycle + kLag), at(t), kCycle);
    }
}

TEST(LegLagEstimator, LearnsTheLagOfLegsThatMove) {
    LegLagEstimator estimator;
    EXPECT_EQ(estimator.lags(), LegLengths(LegLengths::Constant(LegLagEstimator::guess())));
    swing(estimator, 20.0, 0.3);
    for (const double lag : estimator.lags())
        EXPECT_NEAR(lag, kLag, kLearned);
}

TEST(LegLagEstimator, LearnsNothingOfLegsThatStand) {
    LegLagEstimator estimator;
    const LegLengths there = LegLengths::Constant(0.3);
    for (int k = 0; k < 1000; ++k) // a load holds them off their set-points; the rounding makes them tremble
        estimator.add(there + LegLengths::Constant(0.002), there + LegLengths::Constant(k % 2 * 2e-6),
                      kCycle);
    EXPECT_EQ(estimator.lags(), LegLengths(LegLengths::Constant(LegLagEstimator::guess())));
}

TEST(LegLagEstimator, LearnsNothingOfLegsThatGiveWaySlowlyUnderALoad) {
    LegLagEstimator estimator;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> tremble(-2e-6, 2e-6); // m
    constexpr double kCreep = 3e-4;                              // m/s: nobody calls that a motion
    const LegLengths there = LegLengths::Constant(0.3);
    for (int k = 0; k < 1000; ++k) {
        const LegLengths measured = there - LegLengths::Constant(kCreep * kCycle * k + tremble(random));
        estimator.add(measured - LegLengths::Constant(0.002), measured, kCycle); // the load pulls it out
    }
    EXPECT_EQ(estimator.lags(), LegLengths(LegLengths::Constant(LegLagEstimator::guess())));
}

TEST(LegLagEstimator, LearnsNothingOfAPause) {
    LegLagEstimator estimator;
    swing(estimator, 20.0, 0.3);
    const LegLengths before = estimator.lags();
    estimator.interrupt();
    // They were moved by others meanwhile. Too few measurements for a rate, then as many as there were
    // before.
    swing(estimator, 5 * kCycle, 0.4);
    EXPECT_EQ(estimator.lags(), before);
    swing(estimator, 20.0, 0.4);
    for (const double lag : estimator.lags())
        EXPECT_NEAR(lag, kLag, kLearned);
}

TEST(LegLagEstimator, KeepsWithinItsBounds) {
    LegLagEstimator estimator;
    for (int k = 0; k < 1000; ++k) {
        const LegLengths measured = LegLengths::Constant(0.3 + 0.02 * kCycle * k);
        estimator.add(measured + (LegLengths() << 0.05, -0.05, 0.05, -0.05, 0.05, -0.05).finished(), measured,
                      kCycle);
    }
    for (const double lag : estimator.lags()) {
        EXPECT_GE(lag, 0.0);
        EXPECT_LE(lag, LegLagEstimator::longest());
    }
}

} // namespace
} // namespace hexapose
