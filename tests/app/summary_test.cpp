// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/bad_call.h"
#include "tests/app/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hexapose::apptest {
namespace {

using testing::HasSubstr;

const std::string kLog =
    "time_s,l1_mm,state,event\n0,1.5,ready,\n0.1,2.5,moving,\"begun, now\"\n0.2,abc,moving,\n"
    "0.3,4.5,moving\n0.4,5.5,ready,\n";

TEST(Summary, OfEachColumnInTheFilesOrder) {
    const Scratch scratch;
    const std::string file = scratch.file("run.csv", kLog);
    const Outcome outcome = cli({"summary", file});
    EXPECT_EQ(outcome.status, 1) << "a row was left out";
    EXPECT_EQ(outcome.err, file + ":4: l1_mm: \"abc\" is not a number\n" + file +
                               ":5: row left out: 3 fields, but the header has 4\n");
    const Table table(outcome.out);
    ASSERT_EQ(table.rows.size(), 4U);
    EXPECT_TRUE(outcome.out.starts_with("column,unit,count,missing,min,max,mean,sigma,rms,first,last\n"));
    EXPECT_EQ(table.field(1, "column"), "l1_mm");
    EXPECT_EQ(table.field(1, "unit"), "mm");
    EXPECT_EQ(table.field(1, "count"), "3");
    EXPECT_EQ(table.field(1, "missing"), "1");
    EXPECT_EQ(table.number(1, "max"), 5.5);
    EXPECT_EQ(table.field(2, "last"), "ready");
    EXPECT_EQ(table.field(3, "count"), "1");
}

TEST(Summary, OfChosenColumnsAndTimes) {
    const Outcome outcome =
        cli({"summary", "-", "--columns", "state, l1", "--from", "0.05", "--to", "0.1"}, kLog);
    EXPECT_EQ(outcome.status, 1);
    const Table table(outcome.out);
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.field(0, "column"), "l1_mm") << "the order is the file's";
    EXPECT_EQ(table.number(0, "mean"), 2.5);
    EXPECT_EQ(table.field(1, "first"), "moving");
}

TEST(Summary, OfAGoodFileIsQuiet) {
    const Outcome outcome =
        cli({"summary", "-"}, "t;a\n0;1,5\n1;2,5\n", {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(Table(outcome.out).number(1, "mean"), 2.0);
}

TEST(Summary, RefusesBadCalls) {
    const Scratch scratch;
    const std::string file = scratch.file("run.csv", kLog);
    EXPECT_THAT(cli({"summary", file, "--columns", "l9"}).err, HasSubstr("--columns: 'l9' is no column of"));
    EXPECT_THAT(cli({"summary", file, "--from", "2", "--to", "1"}).err, HasSubstr("--from: is behind --to"));
    EXPECT_THAT(cli({"summary", file, "--from", "1,5"}).err, HasSubstr("--from: '1,5' is not a number"));
    const Outcome absent = cli({"summary", scratch.path("absent.csv")});
    EXPECT_EQ(absent.status, 2);
    EXPECT_EQ(std::count(absent.err.begin(), absent.err.end(), '\n'), 1);
    EXPECT_EQ(cli({"summary", scratch.file("empty.csv", "")}).status, 2);
}

} // namespace
} // namespace hexapose::apptest
