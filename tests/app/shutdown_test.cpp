// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// However a program ends after it has enabled the drives: STOP and DISABLE go out, and the platform is not
// left to the controller's watchdog.
#include "tests/app/run_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

namespace hexapose::apptest {
namespace {

using Misdeed = ForeignController::Misdeed;
using testing::IsEmpty;
using testing::Not;

void expectStoppedAndDisabled(ForeignController& controller) {
    EXPECT_TRUE(controller.waitFor([&] { return controller.state() != 'E'; })) << "left enabled";
    EXPECT_THAT(controller.payloads("STOP"), Not(IsEmpty()));
    EXPECT_THAT(controller.payloads("DISABLE"), Not(IsEmpty()));
    EXPECT_EQ(controller.watchdogTrips(), 0) << "left to the watchdog";
    EXPECT_THAT(controller.violations(), IsEmpty());
}

bool isMoving(const ForeignController& controller) {
    constexpr std::size_t kWellUnderWay = 30;
    return controller.state() == 'E' && controller.payloads("SET").size() > kWellUnderWay;
}

class EndsBySignal : public testing::TestWithParam<int> {};

TEST_P(EndsBySignal, RunInMidMove) {
    Bench bench(asTheyAre({}));
    Process program(cliWords(bench.words()));
    ASSERT_TRUE(bench.controller.waitFor([&] { return isMoving(bench.controller); }));
    program.signal(GetParam());
    EXPECT_EQ(program.wait().status, 1);
    expectStoppedAndDisabled(bench.controller);
}

#ifdef HEXAPOSE_CONSOLE
TEST_P(EndsBySignal, HeadlessConsoleInMidMove) {
    const Scratch scratch;
    ForeignController controller(scratch.path("port"), asTheyAre({}), {});
    Process program({HEXAPOSE_CONSOLE, "--headless", "--method", "newton", "--log-dir", scratch.path("logs"),
                     "--port", scratch.path("port")});
    ASSERT_TRUE(controller.waitFor([&] { return isMoving(controller); }));
    program.signal(GetParam());
    EXPECT_EQ(program.wait().status, 1);
    expectStoppedAndDisabled(controller);
}
#endif

INSTANTIATE_TEST_SUITE_P(Signals, EndsBySignal, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& row) { return std::string(sigabbrev_np(row.param)); });

TEST(EndOfRun, WhenEveryPoseWasVisited) {
    const Ran ran = runWell(asTheyAre({}), {}, {kFigure7});
    EXPECT_EQ(ran.outcome.status, 0) << ran.outcome.err;
    expectStoppedAndDisabled(ran.bench->controller);
}

TEST(EndOfRun, WhenTheRunFails) {
    for (const Misdeed misdeed : {Misdeed::RefuseSets, Misdeed::Silence, Misdeed::Stop}) {
        SCOPED_TRACE(static_cast<int>(misdeed));
        Bench bench(asTheyAre({}), {misdeed});
        EXPECT_EQ(bench.run().status, 1);
        expectStoppedAndDisabled(bench.controller);
    }
}

} // namespace
} // namespace hexapose::apptest
