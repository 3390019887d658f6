// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/table/column_summary.h"
#include "core/table/statistics.h"
#include "tests/core/table/table_files.h"

#include <gmock/gmock.h>

#include <cmath>

namespace hexapose {
namespace {

using namespace testing_support;

TEST(Statistics, OfAFewNumbers) {
    const auto table = tableOf("t,a\n0,\n1,1\n2,2\n3,\n4,6\n5,\n");
    const Statistics all = statisticsOf(table->columns()[1], 0, 6);
    EXPECT_EQ(all.count, 3U);
    EXPECT_EQ(all.missing, 3U);
    EXPECT_EQ(all.min, 1.0);
    EXPECT_EQ(all.max, 6.0);
    EXPECT_EQ(all.mean, 3.0);
    EXPECT_DOUBLE_EQ(all.sigma, std::sqrt(7.0));
    EXPECT_DOUBLE_EQ(all.rms, std::sqrt(41.0 / 3.0));
    EXPECT_EQ(all.first, 1.0);
    EXPECT_EQ(all.last, 6.0);
    const Statistics one = statisticsOf(table->columns()[1], 1, 2);
    EXPECT_EQ(one.count, 1U);
    EXPECT_TRUE(std::isnan(one.sigma));
    const Statistics none = statisticsOf(table->columns()[1], 0, 1);
    EXPECT_EQ(none.count, 0U);
    EXPECT_TRUE(std::isnan(none.mean));
    const Statistics parts = statisticsOf(table->columns()[1], {{4, 6}, {0, 2}});
    EXPECT_EQ(parts.first, 6.0);
    EXPECT_EQ(parts.last, 1.0);
    EXPECT_EQ(parts.mean, 3.5);
}

/// Numbers of 1e6 and steps of 1e-6, over several blocks.
TEST(Statistics, KeepTheSigmaOfSmallStepsOnALargeNumber) {
    std::string text = "t,a\n";
    constexpr int kRows = 20000;
    for (int i = 0; i < kRows; ++i)
        text += std::to_string(i) + (i % 2 == 0 ? ",1000000.000001\n" : ",1000000.000003\n");
    const auto table = tableOf(text);
    const Statistics all = statisticsOf(table->columns()[1], 0, kRows);
    EXPECT_NEAR(all.sigma, 1e-6 * std::sqrt(kRows / (kRows - 1.0)), 1e-10);
    EXPECT_NEAR(all.mean, 1000000.000002, 1e-9);
}

TEST(Summary, TimesAreExactAndWordsAreCounted) {
    const auto table = tableOf("timestamp,iso,state\n1795953600123,2026-11-29T12:00:00.25+01:00,a\n"
                               "1795953600125,2026-11-29T12:00:01+01:00,\n");
    const std::vector<RowRange> all{{0, 2}};
    const ColumnSummary millis = summarize(table->columns()[0], all);
    EXPECT_EQ(millis.min, "1795953600123");
    EXPECT_EQ(millis.last, "1795953600125");
    EXPECT_EQ(millis.mean, "1795953600124");
    const ColumnSummary iso = summarize(table->columns()[1], all);
    EXPECT_EQ(iso.first, "2026-11-29T11:00:00.25Z");
    EXPECT_EQ(iso.max, "2026-11-29T11:00:01Z");
    EXPECT_EQ(iso.mean, "");
    const ColumnSummary words = summarize(table->columns()[2], all);
    EXPECT_EQ(words.count, 1U);
    EXPECT_EQ(words.missing, 1U);
    EXPECT_EQ(words.first, "a");
    EXPECT_EQ(timeText(-1'500'000'000, TimeText::Seconds), "-1.5");
    EXPECT_EQ(timeText(-500'000'000, TimeText::Seconds), "-0.5");
    EXPECT_EQ(timeText(1, TimeText::Seconds), "0.000000001");
}

} // namespace
} // namespace hexapose
