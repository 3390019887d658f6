// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The plan in time against the closed form of the seven-piece profile, and against its own limits.

#include "core/motion/path_timing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hexapose {
namespace {

constexpr double kSamples = 20000;
constexpr double kTimeSlack = 1e-4;  ///< of the duration
constexpr double kLimitSlack = 3e-3; ///< of a limit: the plan is made of steps
constexpr double kSteepSlack = 1e-2; ///< the same, where the limit itself changes within a step

double unlimited(double) {
    return std::numeric_limits<double>::infinity();
}

/// Shortest time of a path of length 1 from rest to rest under constant limits.
double closedForm(const PathBounds& b) {
    const auto toSpeed = [&](double v) {
        return v * b.jerk >= b.acceleration * b.acceleration ? v / b.acceleration + b.acceleration / b.jerk
                                                             : 2.0 * std::sqrt(v / b.jerk);
    };
    double v = b.rate;
    if (v * toSpeed(v) > 1.0) { // full speed is never reached: bisection
        double low = 0.0, high = v;
        for (int i = 0; i < 200; ++i)
            (0.5 * (low + high) * toSpeed(0.5 * (low + high)) < 1.0 ? low : high) = 0.5 * (low + high);
        v = low;
    }
    return 2.0 * toSpeed(v) + (1.0 - v * toSpeed(v)) / v;
}

/// As fast as the closed form says, within the bounds at every instant, each derivative that of the one
/// before.
void expectFastestWithin(const PathBounds& bounds, const PathTiming& timing) {
    EXPECT_NEAR(timing.duration(), closedForm(bounds), kTimeSlack * closedForm(bounds));
    PathTiming::State last;
    const double step = timing.duration() / kSamples;
    for (int i = 0; i <= kSamples; ++i) {
        const PathTiming::State state = timing.at(i * step);
        EXPECT_LE(state.rate, bounds.rate * (1.0 + kLimitSlack));
        EXPECT_GE(state.rate, -1e-9);
        EXPECT_LE(std::abs(state.acceleration), bounds.acceleration * (1.0 + kLimitSlack));
        EXPECT_LE(std::abs(state.acceleration - last.acceleration), bounds.jerk * step * 1.01 + 1e-9);
        EXPECT_NEAR(state.s - last.s, 0.5 * (state.rate + last.rate) * step,
                    bounds.jerk * step * step * step + 1e-9);
        last = state;
    }
}

class Profile : public ::testing::TestWithParam<PathBounds> {};

TEST_P(Profile, IsTheFastestAndKeepsItsLimits) {
    const PathBounds bounds = GetParam();
    expectFastestWithin(bounds, PathTiming(bounds, unlimited));
}

/// A limit that is lower only where the platform is at rest anyway makes the plan one of steps, and costs no
/// time. A plan that runs over its end, or leaves some of the acceleration unused, takes longer.
TEST_P(Profile, IsAsFastUnderARateLimitThatIsNotInTheWay) {
    const PathBounds bounds = GetParam();
    const auto lowAtRest = [&](double s) { return s > 0.0 ? bounds.rate : 0.999 * bounds.rate; };
    expectFastestWithin(bounds, PathTiming(bounds, lowAtRest));
}

INSTANTIATE_TEST_SUITE_P(Bounds, Profile,
                         ::testing::Values(PathBounds{0.67, 2.7, 27.0}, PathBounds{10.0, 2.7, 27.0},
                                           PathBounds{0.67, 2.7, 2.7}, PathBounds{5.0, 50.0, 10.0},
                                           PathBounds{0.1, 5.0, 100.0}));

TEST(PathTiming, BeginsAndEndsAtRestAndStaysThere) {
    const PathTiming timing({0.67, 2.7, 27.0}, unlimited);
    for (const double t : {-1.0, 0.0}) {
        EXPECT_EQ(timing.at(t).s, 0.0);
        EXPECT_EQ(timing.at(t).rate, 0.0);
    }
    for (const double t : {timing.duration(), timing.duration() + 5.0}) {
        EXPECT_EQ(timing.at(t).s, 1.0);
        EXPECT_EQ(timing.at(t).rate, 0.0);
    }
    EXPECT_NEAR(timing.at(timing.duration() - 1e-9).s, 1.0, 1e-9);
}

TEST(PathTiming, OfBoundsThatAreNoneNeverEnds) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, infinity, std::nan("")})
        for (const PathBounds& bounds :
             {PathBounds{bad, 1.0, 1.0}, PathBounds{1.0, bad, 1.0}, PathBounds{1.0, 1.0, bad}}) {
            const PathTiming timing(bounds, unlimited);
            EXPECT_EQ(timing.duration(), infinity);
            EXPECT_EQ(timing.at(1.0).s, 0.0);
        }
    const PathTiming stuck({1.0, 1.0, 1.0}, [](double s) { return s > 0.5 ? 0.0 : 1.0; });
    EXPECT_EQ(stuck.duration(), infinity);
}

TEST(PathTiming, TellsItsHighestRateAndAcceleration) {
    const auto narrow = [](double s) { return 0.5 - 0.35 * std::exp(-std::pow((s - 0.5) / 0.1, 2)); };
    for (const PathTiming& timing :
         {PathTiming({0.67, 2.7, 27.0}, narrow), PathTiming({0.67, 2.7, 2.7}, unlimited),
          PathTiming({5.0, 50.0, 10.0}, unlimited)}) {
        double rate = 0.0, acceleration = 0.0;
        for (int i = 0; i <= kSamples; ++i) {
            const PathTiming::State state = timing.at(timing.duration() * i / kSamples);
            rate = std::max(rate, state.rate);
            acceleration = std::max(acceleration, std::abs(state.acceleration));
        }
        EXPECT_LE(rate, timing.maxRate() * (1.0 + 1e-12));
        EXPECT_GT(rate, 0.999 * timing.maxRate());
        EXPECT_LE(acceleration, timing.maxAcceleration() * (1.0 + 1e-12));
        EXPECT_GT(acceleration, 0.99 * timing.maxAcceleration());
    }
}

/// A narrow place on the way: slow there, and nowhere else.
TEST(PathTiming, FollowsARateLimitAlongTheWay) {
    const auto narrow = [](double s) { return 0.5 - 0.35 * std::exp(-std::pow((s - 0.5) / 0.1, 2)); };
    const PathTiming timing({0.67, 2.7, 27.0}, narrow);
    double slowest = 1.0, maxSpeed = 0.0;
    for (int i = 0; i <= kSamples; ++i) {
        const PathTiming::State state = timing.at(timing.duration() * i / kSamples);
        EXPECT_LE(state.rate, narrow(state.s) * (1.0 + kLimitSlack)) << state.s;
        if (std::abs(state.s - 0.5) < 0.01)
            slowest = std::min(slowest, state.rate);
        maxSpeed = std::max(maxSpeed, state.rate);
    }
    EXPECT_GT(slowest, 0.145) << "as fast as it may be in the narrow place";
    EXPECT_GT(maxSpeed, 0.495);
    const PathTiming slow({0.15, 2.7, 27.0}, unlimited);
    EXPECT_LT(timing.duration(), 0.5 * slow.duration()) << "a limit for all of the way takes twice as long";
}

/// The end of a fast stretch: the rate has come down before it, by braking that keeps below the limit all
/// along.
TEST(PathTiming, BrakesInTimeForARateLimitThatFallsSteeply) {
    // Between two samples of the limit, of which there are 256, so that it is known exactly.
    const auto falling = [](double s) {
        return std::clamp(0.6 - 0.55 * (s - 0.5) * 256.0 / 12.0, 0.05, 0.6);
    };
    const PathTiming timing({0.67, 2.7, 27.0}, falling);
    double fastest = 0.0;
    for (int i = 0; i <= kSamples; ++i) {
        const PathTiming::State state = timing.at(timing.duration() * i / kSamples);
        EXPECT_LE(state.rate, falling(state.s) * (1.0 + kSteepSlack)) << state.s;
        fastest = std::max(fastest, state.rate);
    }
    EXPECT_GT(fastest, 0.59);
}

} // namespace
} // namespace hexapose
