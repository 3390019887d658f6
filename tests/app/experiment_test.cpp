// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// hexapose-cli experiment, and run in workspace mode on a controller written from the protocol alone.
#include "tests/app/machine.h"
#include "tests/app/run_bench.h"
#include "tests/app/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace hexapose::apptest {
namespace {

double largestOf(const Table& table, const std::string& mode, const std::string& pushed,
                 const std::string& column) {
    double largest = 0.0;
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        if (table.field(row, "mode") == mode && table.field(row, "pushed") == pushed &&
            table.field(row, column) != "")
            largest = std::max(largest, table.number(row, column));
    return largest;
}

TEST(Experiment, ClosedLoopKeepsToTheLineAndWritesWhatItFound) {
    const Scratch scratch;
    const Outcome outcome = cli({"experiment", "closed-loop", "--out", scratch.path("first")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(readText(scratch.path("first/closed-loop.txt")), outcome.out);
    EXPECT_TRUE(readText(scratch.path("first/closed-loop.pdf")).starts_with("%PDF-"));
    EXPECT_TRUE(readText(scratch.path("first/closed-loop.png")).starts_with("\x89PNG"));
    const Table table(readText(scratch.path("first/closed-loop.csv")));
    ASSERT_EQ(table.rows.size(), 80U) << "20 moves in two modes, pushed and not";
    EXPECT_GT(largestOf(table, "joint", "yes", "deviation_mm"),
              5.0 * largestOf(table, "workspace", "yes", "deviation_mm"));
    EXPECT_GT(largestOf(table, "joint", "no", "deviation_mm"),
              20.0 * largestOf(table, "workspace", "no", "deviation_mm"));
    EXPECT_LT(largestOf(table, "workspace", "no", "speed_percent"), 5.0);
    const Outcome again = cli({"experiment", "closed-loop", "--out", scratch.path("second")});
    EXPECT_EQ(outcome.out, again.out) << "a simulation is the same every time";
}

TEST(Experiment, TakesOtherMachinesLegsAndDisturbances) {
    const Scratch scratch;
    const std::string file = scratch.file("other.toml", octahedral().toml());
    const Outcome outcome =
        cli({"experiment", "closed-loop", "--out", scratch.path("out"), "--platform", file, "--moves", "6",
             "--time-constants-ms", "120,40,200,60,90,20", "--push-mm", "1", "--seed", "9"});
    EXPECT_EQ(outcome.err, "");
    const Table table(readText(scratch.path("out/closed-loop.csv")));
    ASSERT_EQ(table.rows.size(), 24U);
    EXPECT_GT(largestOf(table, "joint", "no", "deviation_mm"),
              5.0 * largestOf(table, "workspace", "no", "deviation_mm"));
}

TEST(Run, InWorkspaceModeReachesTheTargetAndSaysSo) {
    const Ran ran = runWell({}, {}, {kFigure7}, {"--mode", "workspace", "--speed", "80"});
    const Bench& bench = *ran.bench;
    const Outcome& outcome = ran.outcome;
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    expectReached(outcome.out, {kFigure7}, 0.3); // settled is within 0.2 mm
    EXPECT_THAT(readText(bench.scratch.path("log.csv")), testing::HasSubstr(",workspace,80,"));
    EXPECT_THAT(bench.controller.violations(), testing::IsEmpty());
}

TEST(Run, RefusesATargetOutsideTheEnvelopeBeforeAnythingMoves) {
    Bench bench({}, {}, {kFigure7});
    const Outcome outcome = bench.run({"--mode", "workspace", "--envelope-mm", "30"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, testing::HasSubstr("attitude 1: z outside the envelope"));
    EXPECT_THAT(bench.controller.payloads(), testing::IsEmpty());
}

TEST(Run, SweepsAnAxisAndComesBack) {
    runOnVirtual(
        [](const Scratch& scratch) {
            return cli(
                {"run", "--port", "virtual", "--sweep", "z,4,0.2,1,5", "--log", scratch.path("log.csv")});
        },
        [](const Outcome&, const Scratch& scratch) {
            const Table log(readText(scratch.path("log.csv")));
            double highest = 0.0;
            for (std::size_t row = 0; row + 1 < log.rows.size(); ++row)
                if (!log.field(row, "z_mm").empty())
                    highest = std::max(highest, log.number(row, "z_mm"));
            EXPECT_NEAR(highest, 4.0, 1.0);
        });
}

} // namespace
} // namespace hexapose::apptest
