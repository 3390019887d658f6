// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The operator's main job without a screen, against controllers written from the protocol alone.
#include "tests/app/run_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <memory>

namespace hexapose::apptest {
namespace {

namespace fs = std::filesystem;
using Misdeed = ForeignController::Misdeed;
using Plan = ForeignController::Plan;
using Traits = ForeignController::Traits;
using testing::Contains;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::Gt;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

constexpr ForeignController::Ms kHalfWatchdog{125}; ///< of the protocol's 250 ms
const Six kSecond{-6, 5, 20, 3, -2, -4};

TEST(Run, ForeignControllerDoesTheJob) {
    const Ran ran = runWell({}, {}, {kFigure7, kSecond}, {"--report", "@report"});
    const Bench& bench = *ran.bench;
    const Outcome& outcome = ran.outcome;
    const std::string report = bench.scratch.path("report");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(bench.controller.violations(), IsEmpty());
    EXPECT_EQ(bench.controller.watchdogTrips(), 0);
    EXPECT_LT(bench.controller.typicalGap(), kHalfWatchdog);
    EXPECT_NE(bench.controller.state(), 'E') << "left enabled";
    EXPECT_THAT(typesOf(bench.controller.payloads()),
                IsSupersetOf({"HELLO", "HOME", "ENABLE", "SET", "STOP", "DISABLE"}));
    EXPECT_THAT(bench.controller.payloads("HELLO"), SizeIs(Gt(1U))) << "it answers the second only";
    EXPECT_THAT(bench.controller.payloads("CLEAR"), IsEmpty());

    const RunLog log = bench.log();
    EXPECT_EQ(log.strayMeasurement(bench.controller.reports()), "");
    EXPECT_EQ(log.strayPose(laboratory()), "");
    EXPECT_EQ(log.dropped(), 0);
    for (const char* state : {"unreferenced", "disabled", "moving", "settling", "enabled"})
        EXPECT_TRUE(log.has(std::string(",") + state + ",")) << state;
    EXPECT_TRUE(log.has("connected Rig of another make"));
    EXPECT_THAT(readText(bench.scratch.path("log.toml")),
                testing::AllOf(HasSubstr("Laboratory platform"), HasSubstr("program_version"),
                               HasSubstr("model_fingerprint")));

    expectReached(outcome.out, {kFigure7, kSecond}, 0.05);
    expectReport(report);
    EXPECT_EQ(readText(report + "/errors.csv"), outcome.out);
    // The recorded run gives the same report again.
    const std::string again = bench.scratch.path("again");
    const Outcome recorded = cli({"report", bench.scratch.path("log.csv"), "--out", again});
    EXPECT_EQ(recorded.status, 0) << recorded.err;
    expectReached(readText(again + "/errors.csv"), {kFigure7, kSecond}, 0.05);
    expectReport(again);
}

TEST(Run, GoesOnThroughBadFrames) {
    Traits traits;
    traits.bootState = 'D';
    traits.hellosNeeded = 1;
    traits.reportsUnasked = true;
    traits.carriageReturn = false;
    traits.obeysPeriod = true;
    traits.period = ForeignController::Ms(50);
    traits.decimals = 3;
    Plan plan;
    plan.badEvery = 2;
    const Ran ran = runWell(traits, plan, {kFigure7});
    const Bench& bench = *ran.bench;
    const Outcome& outcome = ran.outcome;
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(bench.controller.violations(), IsEmpty());
    EXPECT_THAT(bench.controller.payloads("PERIOD"), Not(IsEmpty()));
    const RunLog log = bench.log();
    EXPECT_EQ(log.strayMeasurement(bench.controller.reports()), "");
    EXPECT_EQ(log.strayPose(laboratory()), "");
    expectReached(outcome.out, {kFigure7}, 0.05);

    const int bad = bench.controller.badSent();
    constexpr int kSentOutsideTheLog = 40; // while nobody listened yet, and at the end
    ASSERT_GT(bad, static_cast<int>(badFrameCount()) + kSentOutsideTheLog) << "each kind once and more";
    EXPECT_GE(log.dropped(), bad - kSentOutsideTheLog);
}

struct Failure {
    const char* name;
    Traits (*change)(Traits);
    Plan plan;
    const char* reason; ///< regular expression, on standard error
    const char* logged; ///< event in the log
    bool stopSent;      ///< STOP is due: the controller may still be moving
    friend void PrintTo(const Failure& row, std::ostream* out) { *out << row.name; }
};

class RunFails : public testing::TestWithParam<Failure> {};

TEST_P(RunFails, WithTheReason) {
    const Failure& failure = GetParam();
    Bench bench(failure.change({}), failure.plan);
    const Outcome outcome = bench.run({"--report", bench.scratch.path("report")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(notOneLineWith(outcome.err, {bench.scratch.path("port")}), "");
    EXPECT_THAT(outcome.err, ContainsRegex(failure.reason));
    EXPECT_THAT(bench.controller.violations(), IsEmpty());
    EXPECT_EQ(bench.controller.misdeedDone(), failure.plan.misdeed != Misdeed::None);
    EXPECT_TRUE(bench.controller.waitFor([&] { return bench.controller.state() != 'E'; })) << "left enabled";
    EXPECT_TRUE(!failure.stopSent || !bench.controller.payloads("STOP").empty());
    const RunLog log = bench.log();
    EXPECT_TRUE(log.has(failure.logged));
    if (failure.plan.misdeed != Misdeed::None) {
        EXPECT_EQ(log.strayMeasurement(bench.controller.reports()), "");
        EXPECT_EQ(log.strayPose(laboratory()), "");
    } else {
        EXPECT_THAT(bench.controller.payloads("SET"), IsEmpty());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Table, RunFails,
    testing::Values(Failure{"Silence", asTheyAre, {Misdeed::Silence}, "stale", "stopped-on-stale-data", true},
                    Failure{"RefusedSetPoint",
                            asTheyAre,
                            {Misdeed::RefuseSets},
                            "SET RANGE leg 2, out of my range",
                            "stopped-on-refusal",
                            true},
                    Failure{"ControllerFault",
                            asTheyAre,
                            {Misdeed::Fault},
                            "42 drive 3: over-current, see manual",
                            "controller-fault",
                            false},
                    Failure{"StopOfTheController",
                            asTheyAre,
                            {Misdeed::Stop},
                            "stopped-by-controller",
                            "stopped-by-controller S",
                            false},
                    Failure{
                        "Restart", asTheyAre, {Misdeed::Restart}, "SET STATE", "stopped-on-refusal", false},
                    Failure{"NarrowerThanThePlatformFile",
                            [](Traits traits) {
                                traits.bootState = 'D';
                                traits.maxMm = 320.0;
                                return traits;
                            },
                            {},
                            "leg [1-6] above max_mm",
                            "move-refused leg",
                            false},
                    Failure{"StoppedBeforehand",
                            [](Traits traits) {
                                traits.bootState = 'S';
                                return traits;
                            },
                            {},
                            "run in stopped; --clear leaves it first",
                            "command-refused",
                            false},
                    Failure{"ListenOnly",
                            [](Traits traits) {
                                traits.listenOnly = true;
                                return traits;
                            },
                            {},
                            "takes no commands",
                            "listen-only",
                            false}),
    [](const auto& row) { return std::string(row.param.name); });

} // namespace
} // namespace hexapose::apptest