// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// CSV as people and spreadsheets write it, and rows that must never give a pose.
#include "tests/app/machine.h"
#include "tests/app/process.h"
#include "tests/app/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace hexapose::apptest {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

const std::string kHeader = "l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm";
const std::string kGood = "339.5,336.5,336.6,329.2,345.1,334.5";

const std::vector<std::string> kNewton{"forward", "-", "--method", "newton"};

TEST(DataFiles, ColumnsAreFoundByNameHoweverTheFileIsWritten) {
    const std::string expected = cli(kNewton, kHeader + "\n" + kGood + "\n").out;
    ASSERT_EQ(Table(expected).rows.size(), 1U);
    const std::vector<std::string> written{
        kHeader + "\r\n" + kGood + "\r\n",
        "\xEF\xBB\xBF" + kHeader + "\n" + kGood + "\n",
        kHeader + "\n" + kGood, // no line end
        "\n" + kHeader + "\n\n" + kGood + "\n\n",
        "l6_mm,note,l5_mm,l4_mm,l3_mm,l2_mm,l1_mm,when\n334.5,\"a, b\",345.1,329.2,336.6,336.5,339.5,now\n",
        " l1_mm , l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n 339.5 , 336.5,336.6,329.2,345.1,334.5\n",
        "\"l1_mm\",l2_mm,l3_mm,l4_mm,l5_mm,l6_mm\n\"339.5\",336.5,336.6,329.2,345.1,334.5\n",
        kHeader + "\n3.395e2,336.50,336.6000,0329.2,345.1,334.5\n",
        kHeader + ",\n" + kGood + ",\n",
    };
    const Scratch scratch;
    for (const std::string& text : written) {
        const Outcome fromInput = cli(kNewton, text);
        EXPECT_EQ(fromInput.status, 0) << text << fromInput.err;
        EXPECT_EQ(fromInput.out, expected) << text;
        EXPECT_EQ(cli({"forward", scratch.file("lengths.csv", text), "--method", "newton"}).out, expected)
            << text;
    }
}

TEST(DataFiles, BadRowsOfLengthsGiveNoPoseAndTheOthersGoOn) {
    const std::vector<std::string> bad{"nan,336.5,336.6,329.2,345.1,334.5",
                                       "339.5,336.5,336.6,329.2,345.1,inf",
                                       "339.5,,336.6,329.2,345.1,334.5",
                                       "339.5,336.5,broken,329.2,345.1,334.5",
                                       "339.5,336.5,336.6 mm,329.2,345.1,334.5",
                                       "339.5,336.5,1e400,329.2,345.1,334.5",
                                       "339.5,336.5,0x150,329.2,345.1,334.5",
                                       "339.5,-336.5,336.6,329.2,345.1,334.5",
                                       "0,336.5,336.6,329.2,345.1,334.5",
                                       "339.5,336.5,336.6",
                                       ",,,,,",
                                       "339,5,336,5,336,6,329,2,345,1,334,5",
                                       "339.5;336.5;336.6;329.2;345.1;334.5"};
    std::string text = kHeader + "\n" + kGood + "\n";
    for (const std::string& row : bad)
        text += row + "\n" + kGood + "\n";
    for (const char* method : {"newton", "newton-as-published", "mpr2", "mpr3", "mpr2-nr", "mpr3-nr"}) {
        SCOPED_TRACE(method);
        const Outcome outcome = cli({"forward", "-", "--method", method, "--start", "previous"}, text);
        EXPECT_EQ(outcome.status, 1);
        const Table table(outcome.out);
        ASSERT_EQ(table.rows.size(), 2 * bad.size() + 1);
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            const bool isBad = row % 2 == 1;
            EXPECT_EQ(table.six(row, poseColumns()).size(), isBad ? 0U : 6U) << row;
            if (isBad) {
                EXPECT_EQ(table.field(row, "status"), "invalid-input") << bad[row / 2];
            } else {
                EXPECT_NEAR(table.number(row, "z_mm"), 39.78, 3.0);
            }
        }
    }
}

TEST(DataFiles, LengthsThatNoPoseHasGiveNoPose) {
    const Outcome outcome =
        cli({"forward", "-"}, kHeader + "\n1,336.5,336.6,329.2,345.1,9000\n" + kGood + "\n");
    EXPECT_EQ(outcome.status, 1);
    const Table table(outcome.out);
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.field(0, "status"), "no-solution");
    EXPECT_TRUE(table.six(0, poseColumns()).empty());
    EXPECT_EQ(table.field(1, "status"), "converged");
}

TEST(DataFiles, PosesOutOfReachSayWhichLegAndBadRowsGiveNoLengths) {
    const Outcome outcome =
        cli({"inverse", "-"}, "gamma_deg,x_mm,y_mm,z_mm,alpha_deg,beta_deg\n"
                              "5,12,-4,40,0,0\n0,0,0,90,0,0\n0,0,0,-70,0,0\n0,nan,0,0,0,0\n"
                              "0,0,0\n0,0,0,0,0,x\n0,0,0,0,0,0\n");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "");
    const Table table(outcome.out);
    ASSERT_EQ(table.rows.size(), 7U);
    EXPECT_EQ(table.field(0, "status"), "ok");
    EXPECT_NEAR(table.number(0, "l1_mm"), laboratory().lengths({12, -4, 40, 0, 0, 5})[0], 1e-9);
    EXPECT_THAT(table.field(1, "status"), testing::MatchesRegex("leg [1-6] above max_mm"));
    EXPECT_THAT(table.field(2, "status"), testing::MatchesRegex("leg [1-6] below min_mm"));
    EXPECT_EQ(table.six(1, lengthColumns()).size(), 6U) << "the lengths it would take";
    for (const std::size_t row : {3U, 4U, 5U}) {
        EXPECT_EQ(table.field(row, "status"), "invalid-input");
        EXPECT_TRUE(table.six(row, lengthColumns()).empty());
    }
    EXPECT_EQ(table.field(6, "status"), "ok");
    EXPECT_EQ(cli({"inverse", "-"}, "x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg\n").status, 0)
        << "no row, no fault";
}

} // namespace
} // namespace hexapose::apptest
