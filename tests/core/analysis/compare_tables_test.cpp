// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/analysis/compare_tables.h"
#include "tests/core/table/table_files.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hexapose {
namespace {

using testing_support::tableOf;

/// Two signals at steps of 10 ms, from a time on, of a clock that is behind by `shift`.
std::string signalsOf(double begin, int rows, double shift, double error = 0.0) {
    std::string text = "time_s,a_mm,b_deg,c,event\n";
    for (int i = 0; i < rows; ++i) {
        const double t = begin + 0.01 * i;
        text += std::to_string(t + shift) + "," +
                std::to_string(10.0 * std::sin(2.0 * t) + std::sin(11.0 * t) + error) + "," +
                std::to_string(std::cos(3.1 * t + 0.2 * t * t)) + ",7," + (i == 50 ? "begin here" : "") +
                "\n";
    }
    return text;
}

TEST(CompareTables, FindsTheShift) {
    const auto a = tableOf(signalsOf(0.0, 1000, 0.0));
    for (const double shift : {0.0, 1.25, -3.217, 100.0}) {
        const auto b = tableOf(signalsOf(0.0, 1000, shift));
        const auto columns = commonColumns(*a, *b);
        ASSERT_EQ(columns.size(), 3U);
        const auto found = findShift(*a, *b, columns);
        ASSERT_TRUE(found);
        EXPECT_NEAR(*found, shift, 1e-6);
        EXPECT_LT(compareColumn(*a, *b, columns[0], *found).rms, 2e-5);
    }
    const auto later = tableOf(signalsOf(3.0, 1000, 0.5)); // the other begins within this one
    const auto found = findShift(*a, *later, commonColumns(*a, *later));
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, 0.5, 1e-6);
}

TEST(CompareTables, ReportsDifferencesAtTheRowsOfTheFirst) {
    const auto a = tableOf(signalsOf(0.0, 300, 0.0)), b = tableOf(signalsOf(0.0, 300, 2.0, 0.5));
    const ColumnDifference all = compareColumn(*a, *b, commonColumns(*a, *b)[0], 2.0);
    EXPECT_EQ(all.count, 300U);
    EXPECT_NEAR(all.rms, 0.5, 1e-5);
    EXPECT_NEAR(all.largest, 0.5, 1e-5);
    const auto gap = tableOf("time_s,a_mm\n0,1\n0.01,\n0.02,3\n0.03,4\n9,5\n");
    EXPECT_TRUE(std::isnan(valueAt(*gap, 1, 0.005)));
    EXPECT_EQ(valueAt(*gap, 1, 0.02), 3.0);
    EXPECT_DOUBLE_EQ(valueAt(*gap, 1, 0.025), 3.5);
    EXPECT_TRUE(std::isnan(valueAt(*gap, 1, 5.0))) << "within a pause";
    EXPECT_TRUE(std::isnan(valueAt(*gap, 1, -1.0)));
    EXPECT_TRUE(std::isnan(valueAt(*gap, 1, 9.5)));
}

TEST(CompareTables, AlignsByEvents) {
    const auto a = tableOf(signalsOf(0.0, 100, 0.0));
    EXPECT_DOUBLE_EQ(*timeOfEvent(*a, "begin"), 0.5);
    EXPECT_FALSE(timeOfEvent(*a, "end"));
    EXPECT_FALSE(timeOfEvent(*tableOf("t,a\n0,1\n"), "begin"));
}

TEST(CompareTables, FindsNoShiftOfWhatDoesNotChange) {
    const auto still = tableOf("time_s,a\n0,1\n1,1\n2,1\n3,1\n");
    EXPECT_FALSE(findShift(*still, *still, commonColumns(*still, *still)));
    const auto other = tableOf("time_s,a [mm]\n0,1\n");
    EXPECT_TRUE(commonColumns(*still, *other).empty());
}

} // namespace
} // namespace hexapose
