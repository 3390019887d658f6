// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The operator's main job without a screen, against controllers written from the protocol alone.
#include "tests/app/foreign_controller.h"
#include "tests/app/process.h"
#include "tests/app/run_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <ostream>

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
const Six kFigure7{12, -4, 40, 0, 0, 5};
const Six kSecond{-6, 5, 20, 3, -2, -4};

/// A controller on a port, targets, and where the log goes.
struct Bench {
    explicit Bench(const Traits& traits = {}, const Plan& plan = {}, std::vector<Six> poses = {kFigure7})
        : targets(scratch.file("targets.csv", csv(poseColumns(), poses))),
          controller(scratch.path("port"), traits, plan) {}

    std::vector<std::string> words(const std::string& logName = "log.csv") const {
        return {"run", "--port", scratch.path("port"), "--targets", targets, "--log", scratch.path(logName)};
    }
    Outcome run(const std::vector<std::string>& more = {}) {
        std::vector<std::string> all = words();
        all.insert(all.end(), more.begin(), more.end());
        return cli(all);
    }
    RunLog log(const std::string& name = "log.csv") const { return RunLog(scratch.path(name)); }

    Scratch scratch;
    std::string targets;
    ForeignController controller;
};

struct Ran {
    std::unique_ptr<Bench> bench;
    Outcome outcome;
};

constexpr int kAttempts = 3;

/// A run that must go well. It is repeated when the machine was too busy even for the controller to keep its
/// times.
Ran runWell(const Traits& traits, const Plan& plan, const std::vector<Six>& poses, bool report) {
    Ran ran;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        ran.bench = std::make_unique<Bench>(traits, plan, poses);
        std::vector<std::string> more;
        if (report)
            more = {"--report", ran.bench->scratch.path("report")};
        ran.outcome = ran.bench->run(more);
        if (ran.outcome.status == 0 || !ran.bench->controller.starved())
            break;
    }
    return ran;
}

std::vector<std::string> typesOf(const std::vector<std::string>& payloads) {
    std::vector<std::string> types;
    for (const std::string& payload : payloads) {
        const std::string type = splitFields(payload).front();
        if (types.empty() || types.back() != type)
            types.push_back(type);
    }
    return types;
}

/// errors.csv of a run that went well: reached within what the resolution explains.
void expectReached(const std::string& errorsCsv, const std::vector<Six>& targets, double withinMm) {
    const Table errors(errorsCsv);
    ASSERT_THAT(errors.rows, SizeIs(targets.size()));
    for (std::size_t row = 0; row < targets.size(); ++row) {
        EXPECT_EQ(errors.field(row, "status"), "converged");
        for (std::size_t k = 0; k < 6; ++k)
            EXPECT_NEAR(errors.number(row, poseColumns()[k]), targets[row][k], withinMm) << poseColumns()[k];
    }
}

void expectReport(const std::string& directory) {
    EXPECT_THAT(readText(directory + "/report.pdf"), StartsWith("%PDF-"));
    EXPECT_THAT(readText(directory + "/errors.png"), StartsWith("\x89PNG"));
    EXPECT_THAT(readText(directory + "/errors.svg"), HasSubstr("<svg"));
}

TEST(Run, ForeignControllerDoesTheJob) {
    const Ran ran = runWell({}, {}, {kFigure7, kSecond}, true);
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
                IsSupersetOf({"HELLO", "HOME", "ENABLE", "SET", "DISABLE"}));
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
    const Ran ran = runWell(traits, plan, {kFigure7}, false);
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

Traits asTheyAre(Traits traits) {
    traits.bootState = 'D';
    return traits;
}

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

TEST(Run, NobodyThere) {
    Traits traits;
    traits.hellosNeeded = 1000000;
    Bench bench(traits);
    const Outcome outcome = bench.run();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(notOneLineWith(outcome.err, {bench.scratch.path("port"), "no controller answered"}), "");
    EXPECT_THAT(typesOf(bench.controller.payloads()), ElementsAre("HELLO"));
    EXPECT_THAT(bench.controller.violations(), IsEmpty());
}

TEST(Run, AnAnswerThatIsOfNoUseIsTold) {
    const std::vector<std::pair<std::string, std::string>> rows = {
        {"ERR,HELLO,UNKNOWN,what", "HELLO UNKNOWN what"},
        {"IDENT,1,rig,6,10,nan,350", "IDENT"},
        {"IDENT,2,rig,6,10,250,350", "protocol version 2"}};
    for (const auto& [answer, words] : rows) {
        SCOPED_TRACE(answer);
        Traits traits;
        traits.helloAnswer = answer;
        traits.hellosNeeded = 1;
        Bench bench(traits);
        const Outcome outcome = bench.run();
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(notOneLineWith(outcome.err, {bench.scratch.path("port"), "no usable answer", words}), "");
    }
}

TEST(Run, UnpluggedOnTheWayAndPluggedInAgain) {
    Plan plan{Misdeed::Unplug, ForeignController::Ms(300)};
    Bench bench(asTheyAre({}), plan);
    const Outcome outcome = bench.run();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(notOneLineWith(outcome.err, {"link-lost"}), "");
    EXPECT_TRUE(bench.log().has("link-lost"));
    // Behind the same name the next run finds it again.
    ASSERT_TRUE(bench.controller.waitFor([&] { return bench.controller.boots() == 2; }));
    Outcome second;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        second = cli(bench.words("second" + std::to_string(attempt) + ".csv"));
        if (second.status == 0 || !bench.controller.starved())
            break;
    }
    EXPECT_EQ(second.status, 0) << second.err;
    expectReached(second.out, {kFigure7}, 0.05);
    EXPECT_THAT(bench.controller.violations(), IsEmpty());
}

bool hasMoved(const ForeignController& controller, double mm) {
    const Six home = laboratory().lengths({});
    const Six legs = controller.legs();
    return controller.state() == 'E' && std::abs(legs[0] - home[0]) > mm;
}

void expectStoppedBy(int signal) {
    SCOPED_TRACE(signal);
    Bench bench(asTheyAre({}));
    Process program(cliWords(bench.words()));
    ASSERT_TRUE(bench.controller.waitFor([&] { return hasMoved(bench.controller, 5.0); }));
    program.signal(signal);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(notOneLineWith(outcome.err, {"interrupted"}), "");
    EXPECT_THAT(bench.controller.payloads("STOP"), Not(IsEmpty()));
    EXPECT_NE(bench.controller.state(), 'E');
    EXPECT_EQ(bench.controller.watchdogTrips(), 0) << "stopped, not merely left alone";
    EXPECT_THAT(bench.controller.violations(), IsEmpty());
}

TEST(Run, InterruptedStopsThePlatform) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        expectStoppedBy(signal);
}

TEST(Run, KilledLosesATenthOfASecondOfTheLog) {
    Bench bench(asTheyAre({}));
    std::vector<LenFrame> sent;
    {
        Process program(cliWords(bench.words()));
        ASSERT_TRUE(bench.controller.waitFor([&] {
            sent = bench.controller.reports();
            return hasMoved(bench.controller, 8.0);
        }));
        program.signal(SIGKILL);
        EXPECT_EQ(program.wait().status, 128 + SIGKILL);
    }
    const RunLog log = bench.log();
    constexpr std::size_t kTenth = 5; // frames at 20 ms
    constexpr std::size_t kSlack = 5; // for the system to let the programs run
    EXPECT_LE(log.sentAfterLast(sent), kTenth + kSlack);
    EXPECT_EQ(log.strayMeasurement(bench.controller.reports()), "");
    EXPECT_EQ(log.strayPose(laboratory()), "");
    EXPECT_TRUE(bench.controller.waitFor([&] { return bench.controller.state() == 'S'; }));
    const Outcome report = cli({"report", bench.scratch.path("log.csv"), "--out", bench.scratch.path("out")});
    EXPECT_EQ(report.status, 2);
    EXPECT_THAT(report.err, HasSubstr("no settled attitude"));
}

TEST(Run, VirtualPlatformOfAnotherGeometry) {
    const Scratch scratch;
    const Machine machine = irregular(5);
    const std::vector<Six> targets = machine.poses(1, 15.0, 6.0, 2);
    const std::string targetFile = scratch.file("targets.csv", csv(poseColumns(), targets));
    const Outcome outcome = cli({"run", "--platform", scratch.file("machine.toml", machine.toml()), "--port",
                                 "virtual", "--targets", targetFile, "--log", scratch.path("log.csv"),
                                 "--report", scratch.path("deep/report")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    expectReached(outcome.out, targets, 0.3); // lengths come in steps of 0.1 mm
    expectReport(scratch.path("deep/report"));
    EXPECT_EQ(RunLog(scratch.path("log.csv")).strayPose(machine), "");
    // The platform stands beside the log: the report needs no telling.
    const Outcome report = cli({"report", scratch.path("log.csv"), "--out", scratch.path("again")});
    EXPECT_EQ(report.status, 0) << report.err;
    expectReached(readText(scratch.path("again/errors.csv")), targets, 0.3);
}

TEST(Run, SimulatedFaultsAreCountedAndDoNoHarm) {
    const Scratch scratch;
    Process platform(cliWords({"simulate", "--protocol", "line", "--link", scratch.path("port"), "--faults",
                               "crc=0.05,drop=0.05,garbage=0.05,nan=0.05,torn=0.05,seed=9"}));
    platform.readLine();
    const std::string targets = scratch.file("targets.csv", csv(poseColumns(), {kFigure7}));
    const Outcome outcome =
        cli({"run", "--port", scratch.path("port"), "--targets", targets, "--log", scratch.path("log.csv")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    expectReached(outcome.out, {kFigure7}, 0.2);
    const RunLog log(scratch.path("log.csv"));
    EXPECT_EQ(log.strayPose(laboratory()), "");
    EXPECT_GT(log.dropped(), 10);
}

} // namespace
} // namespace hexapose::apptest
