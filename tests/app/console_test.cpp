// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The console as a program, without a display.
#include "tests/app/bad_call.h"
#include "tests/app/foreign_controller.h"
#include "tests/app/run_bench.h"
#include "tests/app/run_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <functional>
#include <sstream>

namespace hexapose::apptest {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

/// The paths that a headless run prints after "what: ".
std::vector<std::string> printed(const std::string& out, const std::string& what) {
    std::vector<std::string> paths;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(what + ": "))
            paths.push_back(line.substr(what.size() + 2));
    return paths;
}

void expectReported(const Outcome& outcome, const Scratch& scratch, const Machine& machine) {
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    ASSERT_THAT(printed(outcome.out, "log"), SizeIs(1));
    const RunLog log(printed(outcome.out, "log").front());
    EXPECT_EQ(log.strayPose(machine), "");
    EXPECT_TRUE(log.has("settled"));
    ASSERT_THAT(printed(outcome.out, "picture"), SizeIs(1));
    EXPECT_THAT(readText(printed(outcome.out, "picture").front()), StartsWith("\x89PNG"));
    const std::vector<std::string> report = printed(outcome.out, "report");
    EXPECT_THAT(report, SizeIs(4));
    for (const std::string& file : report) {
        EXPECT_THAT(file, StartsWith(scratch.path("out")));
        EXPECT_FALSE(readText(file).empty()) << file;
    }
    const Table errors(readText(scratch.path("out/errors.csv")));
    EXPECT_GE(errors.rows.size(), 3U);
    for (std::size_t row = 0; row < errors.rows.size(); ++row)
        EXPECT_THAT(errors.field(row, "status"), AnyOf("converged", "outside-model"));
}

void expectJobDone(const Outcome& outcome, const Scratch& scratch) {
    expectReported(outcome, scratch, laboratory());
    ASSERT_THAT(printed(outcome.out, "log"), SizeIs(1));
    const RunLog log(printed(outcome.out, "log").front());
    // The attitude of the published test was reached.
    double nearest = 1e9;
    for (std::size_t row = 0; row + 1 < log.table().rows.size(); ++row)
        if (log.table().field(row, "state") == "enabled" && !log.table().field(row, "z_mm").empty())
            nearest = std::min(nearest, std::abs(log.table().number(row, "z_mm") - 40.0));
    EXPECT_LT(nearest, 0.2);
}

Outcome headless(const Scratch& scratch, const std::vector<std::string>& more,
                 const Process::Environment& environment = {}) {
    std::vector<std::string> words{HEXAPOSE_CONSOLE,    "--headless", "--output",
                                   scratch.path("out"), "--log-dir",  scratch.path("logs")};
    words.insert(words.end(), more.begin(), more.end());
    Process process(words, {}, environment);
    return process.wait();
}

/// Once more where the machine was too busy.
void expectWell(const std::function<Outcome(const Scratch&)>& job,
                const std::function<void(const Outcome&, const Scratch&)>& judge) {
    for (int attempt = 1; attempt <= kAttempts; ++attempt) {
        const Scratch scratch;
        const Outcome outcome = job(scratch);
        if (wasTooBusy(outcome) && attempt < kAttempts)
            continue;
        return judge(outcome, scratch);
    }
}

TEST(Console, HeadlessDoesTheJobOnTheVirtualPlatform) {
    expectWell(
        [](const Scratch& scratch) {
            return headless(scratch, {"--virtual", "--language", "zh_CN"}, {{"LC_ALL", "de_DE.UTF-8"}});
        },
        expectJobDone);
}

TEST(Console, HeadlessDoesTheJobOnAMachineThatCannotReachThePublishedAttitude) {
    const Machine small = scaled(octahedral(), 0.1);
    expectWell(
        [&](const Scratch& scratch) {
            return headless(scratch, {"--virtual", "--platform", scratch.file("small.toml", small.toml())});
        },
        [&](const Outcome& outcome, const Scratch& scratch) { expectReported(outcome, scratch, small); });
}

TEST(Console, HeadlessDoesTheJobOnAForeignController) {
    for (int attempt = 1; attempt <= kAttempts; ++attempt) {
        const Scratch scratch;
        ForeignController controller(scratch.path("port"), {}, {});
        const Outcome outcome = headless(scratch, {"--port", scratch.path("port")});
        const bool busy = wasTooBusy(outcome) || (outcome.status != 0 && controller.starved());
        if (busy && attempt < kAttempts)
            continue;
        expectJobDone(outcome, scratch);
        EXPECT_THAT(controller.violations(), IsEmpty());
        EXPECT_EQ(controller.watchdogTrips(), 0);
        EXPECT_NE(controller.state(), 'E') << "left enabled";
        break;
    }
}

TEST(Console, HeadlessFailsWithTheReasonWhenTheControllerFallsSilent) {
    const Scratch scratch;
    ForeignController controller(scratch.path("port"), {}, {ForeignController::Misdeed::Silence});
    const Outcome outcome = headless(scratch, {"--port", scratch.path("port")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_FALSE(outcome.err.empty());
    EXPECT_THAT(controller.violations(), IsEmpty());
    EXPECT_THAT(controller.payloads(), Contains("STOP"));
}

/// Ends the console in mid-move by a signal.
void expectEndsBy(int signal) {
    SCOPED_TRACE(signal);
    const Scratch scratch;
    ForeignController::Traits traits;
    traits.bootState = 'D';
    ForeignController controller(scratch.path("port"), traits, {});
    Process console({HEXAPOSE_CONSOLE, "--headless", "--output", scratch.path("out"), "--log-dir",
                     scratch.path("logs"), "--port", scratch.path("port")});
    ASSERT_TRUE(controller.waitFor([&] { return controller.payloads("SET").size() > 30; }));
    console.signal(signal);
    const Outcome outcome = console.wait();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "hexapose: interrupted\n");
    EXPECT_TRUE(controller.waitFor([&] { return controller.state() != 'E'; }));
    EXPECT_THAT(controller.payloads(), Contains("STOP"));
    EXPECT_THAT(controller.payloads(), Contains("DISABLE"));
    EXPECT_THAT(controller.violations(), IsEmpty());
    EXPECT_EQ(controller.watchdogTrips(), 0) << "stopped by the host";
}

TEST(Console, StopsAndDisablesWhenASignalEndsIt) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP})
        expectEndsBy(signal);
}

TEST(Console, WithAWindowEndsInOrderByASignal) {
    const Scratch scratch;
    ForeignController::Traits traits;
    traits.bootState = 'E'; // somebody else's: nothing of the console's own moves it
    traits.hellosNeeded = 1;
    ForeignController controller(scratch.path("port"), traits, {});
    Process console({HEXAPOSE_CONSOLE, "--log-dir", scratch.path("logs"), "--port", scratch.path("port")}, {},
                    {{"QT_QPA_PLATFORM", "offscreen"}});
    ASSERT_TRUE(controller.waitFor([&] {
        return !controller.payloads("HELLO").empty() && controller.watchdogTrips() == 1;
    })) << "held unasked";
    console.signal(SIGTERM);
    EXPECT_EQ(console.wait().status, 0);
    EXPECT_THAT(controller.payloads("SET"), IsEmpty()) << "nobody asked for a set-point";
}

/// The solver that the log of a session of a console says it began with.
std::string solverInUse(const std::vector<std::string>& more, const std::string& remembered) {
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path("config/Hexapose"));
    scratch.file("config/Hexapose/hexapose.conf", "[General]\nsolver=" + remembered + "\n");
    ForeignController::Traits traits;
    traits.bootState = 'E';
    traits.hellosNeeded = 1;
    ForeignController controller(scratch.path("port"), traits, {});
    std::vector<std::string> words{HEXAPOSE_CONSOLE, "--log-dir", scratch.path("logs"), "--port",
                                   scratch.path("port")};
    words.insert(words.end(), more.begin(), more.end());
    Process console(words, {},
                    {{"QT_QPA_PLATFORM", "offscreen"}, {"XDG_CONFIG_HOME", scratch.path("config")}});
    // The session, and its log, begin before the first HELLO.
    EXPECT_TRUE(controller.waitFor(
        [&] { return !controller.payloads("HELLO").empty() && controller.watchdogTrips() == 1; }));
    console.signal(SIGTERM);
    EXPECT_EQ(console.wait().status, 0);
    for (const auto& file : std::filesystem::directory_iterator(scratch.path("logs"))) {
        const std::string text = readText(file.path().string());
        const std::size_t at = text.find("\nsolver = ");
        if (file.path().extension() == ".toml" && at != std::string::npos)
            return text.substr(at + 1, text.find('\n', at + 1) - at - 1);
    }
    return "no log";
}

TEST(Console, RemembersTheSolverThatWasChosen) {
    EXPECT_EQ(solverInUse({}, "fsi"), "solver = 'fsi'");
    EXPECT_EQ(solverInUse({"--method", "newton"}, "fsi"), "solver = 'newton'") << "for this once";
    EXPECT_EQ(solverInUse({}, "guess"), "solver = 'mpr3-nr'") << "not a word of ours";
}

TEST(Console, BadOptionsAreRefused) {
    const Scratch scratch;
    scratch.file("plain", "a regular file\n");
    scratch.file("broken.toml", laboratory().toml() + "colour = \"red\"\n");
    expectRefused(HEXAPOSE_CONSOLE, scratch,
                  {
                      {"--colour", {"--colour"}},
                      {"surplus", {"surplus"}},
                      {"--port", {"--port"}},
                      {"--baud", {"--baud"}},
                      {"--platform", {"--platform"}},
                      {"--log-dir", {"--log-dir"}},
                      {"--language", {"--language"}},
                      {"--virtual --port /dev/ttyNOWHERE", {"--port", "--virtual"}},
                      {"--virtual=yes", {"--virtual"}},
                      {"--virtual --method guess", {"--method", "guess", "fsi"}},
                      {"--virtual --headless --virtual", {"--virtual", "twice"}},
                      {"--headless --baud 9600 --baud=9600", {"--baud", "twice"}},
                      {"--headless --port /dev/ttyNOWHERE", {"/dev/ttyNOWHERE"}},
                      {"--port @plain --headless", {"@plain", "not a serial port"}},
                      {"--port @plain", {"@plain", "not a serial port"}},
                      {"--port --headless", {"--port", "needs a value"}},
                      {"--port= --headless", {"--port", "needs a value"}},
                      {"--headless --port /dev/null", {"/dev/null", "not a serial port"}},
                      {"--virtual --baud 0", {"--baud", "0"}},
                      {"--virtual --baud fast", {"--baud", "fast"}},
                      {"--virtual --baud -1", {"--baud"}},
                      {"--virtual --envelope-mm 0", {"--envelope-mm", "'0'", "number above 0"}},
                      {"--virtual --envelope-deg wide", {"--envelope-deg", "wide", "number"}},
                      {"--virtual --envelope-mm 1,5", {"--envelope-mm", "1,5", "number"}},
                      {"--virtual --envelope-mm 5mm", {"--envelope-mm", "5mm", "number"}},
                      {"--virtual --baud 9600x", {"--baud", "9600x", "whole number"}},
                      {"--language xx", {"--language", "xx"}},
                      {"--platform nowhere", {"nowhere"}},
                      {"--platform @missing.toml", {"@missing.toml"}},
                      {"--platform @plain", {"@plain:1:"}},
                      {"--platform @broken.toml", {"@broken.toml:35:", "colour"}},
                      {"--headless --virtual --output @plain/out", {"--output", "@plain/out"}},
                      {"--headless --virtual --output @plain", {"--output", "@plain"}},
                      {"--headless --virtual --log-dir @plain/logs", {"--log-dir", "@plain/logs"}},
                      {"--headless --virtual --log-part-mb huge", {"--log-part-mb", "huge"}},
                      {"--virtual --output @out", {"--output", "--headless"}},
                  });
}

TEST(Console, HelpNamesTheProgramAndItsOptions) {
    Process process({HEXAPOSE_CONSOLE, "--help"});
    const Outcome outcome = process.wait();
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, StartsWith("Usage: hexapose [options]\n"));
    for (const char* option : {"--virtual", "--port <PATH>", "--headless", "--platform <NAME|FILE>"})
        EXPECT_THAT(outcome.out, testing::HasSubstr(option));
}

TEST(Console, HeadlessEndsWhenNobodyAnswers) {
    const Scratch scratch;
    ForeignController::Traits silent;
    silent.hellosNeeded = 1000000;
    ForeignController controller(scratch.path("port"), silent, {});
    const Outcome outcome = headless(scratch, {"--method", "newton", "--port", scratch.path("port")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "hexapose: no controller answered within 10 s\n");
}

/// Base and platform are similar hexagons: there is no pose to move to, and no solution to wait for.
TEST(Console, HeadlessRefusesAPlatformThatIsSingularEverywhere) {
    Machine machine = octahedral();
    machine.platform = machine.base;
    for (auto& joint : machine.platform)
        for (double& coordinate : joint)
            coordinate *= 0.5;
    const Six home = machine.lengths({});
    machine.minMm = 0.8 * *std::min_element(home.begin(), home.end());
    machine.maxMm = 1.2 * *std::max_element(home.begin(), home.end());
    const Scratch scratch;
    const Outcome outcome =
        headless(scratch, {"--virtual", "--platform", scratch.file("singular.toml", machine.toml())});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(notOneLineWith(outcome.err, {"singular"}), "");
    EXPECT_FALSE(std::filesystem::exists(scratch.path("logs"))) << "nothing was begun";
}

TEST(Console, WithAWindowWaitsForAPortThatIsNotThereYet) {
    const Scratch scratch;
    Process console({HEXAPOSE_CONSOLE, "--method", "newton", "--log-dir", scratch.path("logs"), "--port",
                     scratch.path("port")});
    ASSERT_TRUE(eventually([&] {
        for (const auto& [name, text] : scratch.contents())
            if (text.find("link-lost") != std::string::npos)
                return true;
        return false;
    })) << "the log says that there is no port";
    ForeignController controller(scratch.path("port"), {}, {});
    EXPECT_TRUE(controller.waitFor([&] { return !controller.payloads("HELLO").empty(); }));
    console.signal(SIGTERM);
    EXPECT_EQ(console.wait().status, 0);
}

} // namespace
} // namespace hexapose::apptest
