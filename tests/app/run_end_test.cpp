// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How a run ends: by a controller of no use, a lost port, a signal; and on the built-in virtual platform.
#include "tests/app/run_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <future>

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
using testing::SizeIs;

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
    const auto judge = [](const std::string& answer, const std::string& words) {
        Traits traits;
        traits.helloAnswer = answer;
        traits.hellosNeeded = 1;
        Bench bench(traits);
        const Outcome outcome = bench.run();
        const std::string port = bench.scratch.path("port");
        return std::pair(outcome.status, notOneLineWith(outcome.err, {port, "no usable answer", words}));
    };
    std::vector<std::future<std::pair<int, std::string>>> verdicts; // side by side: each takes ten seconds
    for (const auto& [answer, words] : rows)
        verdicts.push_back(std::async(std::launch::async, judge, answer, words));
    for (std::size_t i = 0; i < rows.size(); ++i)
        EXPECT_EQ(verdicts[i].get(), std::pair(1, std::string())) << rows[i].first;
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
        std::vector<std::string> words = bench.words("second" + std::to_string(attempt) + ".csv");
        if (attempt > 0)
            words.emplace_back("--clear"); // the failed attempt left it stopped
        second = cli(words);
        if (second.status == 0 || !(wasTooBusy(second) || bench.controller.starved()))
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
    const Machine machine = irregular(5);
    const std::vector<Six> targets = machine.poses(1, 15.0, 6.0, 2);
    runOnVirtual(
        [&](const Scratch& scratch) {
            return cli({"run", "--platform", scratch.file("machine.toml", machine.toml()), "--port",
                        "virtual", "--targets", scratch.file("targets.csv", csv(poseColumns(), targets)),
                        "--log", scratch.path("log.csv"), "--report", scratch.path("deep/report")});
        },
        [&](const Outcome& outcome, const Scratch& scratch) {
            expectReached(outcome.out, targets, 0.3); // lengths come in steps of 0.1 mm
            expectReport(scratch.path("deep/report"));
            EXPECT_EQ(RunLog(scratch.path("log.csv")).strayPose(machine), "");
            // The platform stands beside the log, and need not be named.
            const Outcome report = cli({"report", scratch.path("log.csv"), "--out", scratch.path("again")});
            EXPECT_EQ(report.status, 0) << report.err;
            expectReached(readText(scratch.path("again/errors.csv")), targets, 0.3);
        });
}

TEST(Run, SimulatedFaultsAreCountedAndDoNoHarm) {
    runOnVirtual(
        [&](const Scratch& scratch) {
            Process platform(
                cliWords({"simulate", "--protocol", "line", "--link", scratch.path("port"), "--faults",
                          "crc=0.05,drop=0.05,garbage=0.05,nan=0.05,torn=0.05,seed=9"}));
            platform.readLine();
            return cli({"run", "--port", scratch.path("port"), "--targets",
                        scratch.file("targets.csv", csv(poseColumns(), {kFigure7})), "--log",
                        scratch.path("log.csv")});
        },
        [&](const Outcome& outcome, const Scratch& scratch) {
            expectReached(outcome.out, {kFigure7}, 0.2);
            const RunLog log(scratch.path("log.csv"));
            EXPECT_EQ(log.strayPose(laboratory()), "");
            EXPECT_GT(log.dropped(), 10);
        });
}

} // namespace
} // namespace hexapose::apptest
