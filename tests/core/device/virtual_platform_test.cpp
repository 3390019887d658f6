// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/simulation/virtual_platform.h"

#include "tests/core/device/test_platform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing_support::testPlatform;
using Refusal = VirtualPlatform::Refusal;

constexpr double kExact = 1e-12; ///< m, round-off of the simulation

VirtualPlatform platformIn(ControllerState state, const VirtualPlatformOptions& options = {}) {
    VirtualPlatform platform(testPlatform(), options);
    if (state == ControllerState::Unreferenced)
        return platform;
    platform.reference();
    platform.step(1ms);
    if (state == ControllerState::Enabled)
        platform.enable();
    if (state == ControllerState::Stopped)
        platform.stop();
    if (state == ControllerState::Fault)
        platform.fail();
    EXPECT_EQ(platform.state(), state);
    return platform;
}

TEST(VirtualPlatform, FollowsTheStateTable) {
    const LegLengths home = testPlatform().homeLengths();
    const std::function<Refusal(VirtualPlatform&)> commands[] = {
        [](VirtualPlatform& p) { return p.reference(); },
        [](VirtualPlatform& p) { return p.enable(); },
        [](VirtualPlatform& p) { return p.disable(); },
        [&](VirtualPlatform& p) { return p.set(home); },
        [](VirtualPlatform& p) { return p.stop(), Refusal::None; },
        [](VirtualPlatform& p) { return p.clear(), Refusal::None; }};
    // State before, then after HOME ENABLE DISABLE SET STOP CLEAR and a millisecond; '-' where it is refused.
    for (const std::string_view row : {"U D-U-SU", "D DED-SD", "E -EDESE", "S --S-SD", "F --F-FD"}) {
        for (std::size_t c = 0; c < std::size(commands); ++c) {
            VirtualPlatform platform = platformIn(*controllerStateFromLetter(row[0]));
            const Refusal refusal = commands[c](platform);
            platform.step(1ms);
            const char expected = row[2 + c];
            EXPECT_EQ(refusal, expected == '-' ? Refusal::State : Refusal::None) << row << " command " << c;
            EXPECT_EQ(toLetter(platform.state()), expected == '-' ? row[0] : expected)
                << row << " command " << c;
            EXPECT_LT((platform.lengths() - home).norm(), kExact);
        }
    }
}

TEST(VirtualPlatform, StoppedWhileUnreferencedIsStillUnreferencedOnceCleared) {
    VirtualPlatform platform = platformIn(ControllerState::Unreferenced);
    platform.stop();
    platform.clear();
    EXPECT_EQ(platform.state(), ControllerState::Unreferenced);
}

TEST(VirtualPlatform, LegsFollowAtFirstOrderEachWithItsOwnTimeConstant) {
    VirtualPlatform platform = platformIn(ControllerState::Enabled);
    const LegLengths start = platform.lengths();
    const double step = 0.004; // below time constant times speed limit of every leg
    ASSERT_EQ(platform.set(start.array() + step), Refusal::None);
    for (int i = 0; i < 100; ++i)
        platform.step(1ms);
    const VirtualPlatformOptions defaults;
    for (int leg = 0; leg < kLegCount; ++leg) {
        const double tau = defaults.timeConstants[static_cast<std::size_t>(leg)];
        EXPECT_NEAR(platform.lengths()[leg] - start[leg], step * (1.0 - std::exp(-0.1 / tau)), kExact) << leg;
    }
}

TEST(VirtualPlatform, NoLegIsFasterThanItsLimitAndTheStepSizeDoesNotMatter) {
    VirtualPlatform fine = platformIn(ControllerState::Enabled);
    VirtualPlatform coarse = platformIn(ControllerState::Enabled);
    const LegLengths target = LegLengths::Constant(0.300);
    ASSERT_EQ(fine.set(target), Refusal::None);
    ASSERT_EQ(coarse.set(target), Refusal::None);
    const LegLengths start = fine.lengths();
    for (int i = 0; i < 200; ++i) {
        const LegLengths before = fine.lengths();
        fine.step(1ms);
        EXPECT_LE((fine.lengths() - before).cwiseAbs().maxCoeff(), 0.100 * 0.001 + kExact);
    }
    coarse.step(200ms);
    EXPECT_LT((fine.lengths() - coarse.lengths()).norm(), 1e-9);
    EXPECT_GT((fine.lengths() - start).cwiseAbs().minCoeff(), 0.015);
}

TEST(VirtualPlatform, WatchdogStopsAfterItsTimeAndHoldsThere) {
    VirtualPlatform platform = platformIn(ControllerState::Enabled);
    ASSERT_EQ(platform.set(LegLengths::Constant(0.300)), Refusal::None);
    platform.step(200ms);
    platform.feedWatchdog();
    platform.step(249ms);
    EXPECT_EQ(platform.state(), ControllerState::Enabled);
    VirtualPlatform oneStep = platform;
    oneStep.step(10s);
    platform.step(1ms);
    EXPECT_EQ(platform.state(), ControllerState::Stopped);
    const LegLengths held = platform.lengths();
    platform.step(10s);
    EXPECT_EQ(platform.lengths(), held);
    EXPECT_LT((oneStep.lengths() - held).norm(), kExact); // a late step moves no further
}

TEST(VirtualPlatform, RefusesTheWholeSetPointWhenOneLegIsOutside) {
    const LegLengths home = testPlatform().homeLengths();
    VirtualPlatform platform = platformIn(ControllerState::Enabled);
    for (const double bad : {0.1899, 0.3101, std::nan("")}) {
        LegLengths lengths = home.array() + 0.01;
        lengths[0] = bad;
        EXPECT_EQ(platform.set(lengths), Refusal::Range) << bad;
    }
    platform.step(100ms);
    EXPECT_LT((platform.lengths() - home).norm(), kExact);
    LegLengths edge = home;
    edge[0] = 0.310;
    edge[5] = 0.315; // leg 6 alone goes so far
    EXPECT_EQ(platform.set(edge), Refusal::None);
}

TEST(VirtualPlatform, ReferencingMovesHomeFirst) {
    VirtualPlatform platform = platformIn(ControllerState::Enabled);
    ASSERT_EQ(platform.set(LegLengths::Constant(0.300)), Refusal::None);
    platform.step(240ms);
    platform.disable();
    ASSERT_EQ(platform.reference(), Refusal::None);
    platform.step(1ms);
    EXPECT_EQ(platform.state(), ControllerState::Unreferenced);
    EXPECT_EQ(platform.enable(), Refusal::State);
    platform.step(5s);
    EXPECT_EQ(platform.state(), ControllerState::Disabled);
    EXPECT_LT((platform.lengths() - testPlatform().homeLengths()).cwiseAbs().maxCoeff(), 2e-5);
}

TEST(VirtualPlatform, MeasuresWithItsResolutionAndSeededNoise) {
    VirtualPlatform quiet(testPlatform());
    for (const double length : quiet.measure()) {
        const double tenths = length * 1e4;
        EXPECT_NEAR(tenths, std::round(tenths), 1e-6);
    }
    EXPECT_LE((quiet.measure() - quiet.lengths()).cwiseAbs().maxCoeff(), 0.5e-4 + kExact);
    const VirtualPlatformOptions noisy{.resolution = 0.0, .noise = 1e-4, .seed = 5};
    VirtualPlatform a(testPlatform(), noisy);
    VirtualPlatform b(testPlatform(), noisy);
    double sum = 0.0;
    constexpr int kCount = 1000;
    for (int i = 0; i < kCount; ++i) {
        const LegLengths measured = a.measure();
        EXPECT_EQ(measured, b.measure());
        sum += (measured - a.lengths()).squaredNorm();
    }
    EXPECT_NEAR(std::sqrt(sum / (kCount * kLegCount)), 1e-4, 1e-5);
}

} // namespace
} // namespace hexapose
