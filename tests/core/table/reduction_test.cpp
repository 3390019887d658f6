// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// What is drawn, against a search through all rows.

#include "core/table/reduction.h"
#include "tests/core/table/table_files.h"
#include "tests/support/sample_count.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace hexapose {
namespace {

using namespace testing_support;

/// A walk with spikes and gaps, at steps that vary.
std::string walk(int rows, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::string text = "time_s,a\n";
    double time = 0.0, value = 0.0;
    for (int i = 0; i < rows; ++i) {
        time += part(random) < 0.001 ? 0.5 : 0.001 * (0.5 + part(random));
        value += part(random) - 0.5;
        const bool spike = part(random) < 0.0005, gap = part(random) < 0.002;
        text += std::to_string(time) + "," +
                (gap ? "" : std::to_string(spike ? 1e6 * (part(random) - 0.5) : value)) + "\n";
    }
    return text;
}

MinMax bruteForce(const Table& table, std::size_t column, Row begin, Row end) {
    MinMax extremes;
    for (Row row = begin; row < end; ++row)
        extremes.add(table.columns()[column].number(row));
    return extremes;
}

bool equal(const MinMax& a, const MinMax& b) {
    return (a.isEmpty() && b.isEmpty()) || a == b;
}

TEST(Pyramid, RangesEqualASearchThroughAllRows) {
    const auto table = tableOf(walk(300000, 1)); // more than a chunk
    std::mt19937_64 random(2);
    for (int i = 0; i < samples(3000); ++i) {
        Row begin = random() % (table->rowCount() + 1), end = random() % (table->rowCount() + 1);
        if (begin > end)
            std::swap(begin, end);
        if (i % 3 == 0)
            end = std::min(begin + random() % 200, table->rowCount());
        ASSERT_TRUE(equal(table->columns()[1].range(begin, end), bruteForce(*table, 1, begin, end)))
            << begin << " to " << end;
    }
    EXPECT_TRUE(table->columns()[1].range(5, 5).isEmpty());
}

TEST(Reduction, DrawnExtremesEqualASearchThroughAllRowsInEveryView) {
    const auto table = tableOf(walk(20000, 3));
    const Column& column = table->columns()[1];
    const TimeAxis& time = table->time();
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int i = 0; i < samples(1000); ++i) {
        const double width = time.end() * std::pow(10.0, -4.0 * part(random));
        const double begin = (time.end() - width) * part(random);
        const TimeView view{begin, begin + width, 1 + static_cast<int>(1500 * part(random))};
        MinMax drawn, searched;
        int before = -2;
        for (const PixelColumn& pixel : reduceToPixels(column, time, view)) {
            ASSERT_GT(pixel.pixel, before);
            before = pixel.pixel;
            ASSERT_TRUE(pixel.min <= pixel.first && pixel.first <= pixel.max && pixel.min <= pixel.last &&
                        pixel.last <= pixel.max && pixel.firstTime <= pixel.lastTime);
            if (pixel.pixel < 0 || pixel.pixel >= view.pixels)
                continue;
            drawn.add({pixel.min, pixel.max});
            MinMax within;
            for (Row row = time.firstAtOrAfter({0, time.rowCount()}, pixel.firstTime);
                 row < time.rowCount() && time.seconds(row) <= pixel.lastTime; ++row)
                within.add(column.number(row));
            ASSERT_TRUE(equal(within, {pixel.min, pixel.max})) << "view " << i << ", pixel " << pixel.pixel;
        }
        for (Row row = 0; row < table->rowCount(); ++row)
            if (time.seconds(row) >= view.begin && time.seconds(row) <= view.end)
                searched.add(column.number(row));
        ASSERT_TRUE(equal(drawn, searched)) << "view " << i;
    }
}

TEST(Reduction, BreaksLinesAtMissingCellsAndPauses) {
    const auto table = tableOf("time_s,a\n0,1\n1,2\n2,\n3,4\n4,5\n20,6\n21,7\n");
    const auto pixels = reduceToPixels(table->columns()[1], table->time(), {0.0, 21.0, 2100});
    std::vector<double> values;
    std::vector<bool> gaps;
    for (const PixelColumn& pixel : pixels) {
        values.push_back(pixel.first);
        gaps.push_back(pixel.gapBefore);
    }
    EXPECT_THAT(values, testing::ElementsAre(1, 2, 4, 5, 6, 7));
    EXPECT_THAT(gaps, testing::ElementsAre(true, false, true, false, true, false));
}

TEST(Reduction, ReachesTheEdgesAndFollowsTimeThatGoesBack) {
    const auto table = tableOf("time_s,a\n0,1\n1,2\n2,3\n3,4\n0.5,5\n1.5,6\n");
    const auto pixels = reduceToPixels(table->columns()[1], table->time(), {0.9, 1.2, 30});
    ASSERT_EQ(pixels.size(), 5U);
    EXPECT_EQ(pixels[0].pixel, -1);
    EXPECT_EQ(pixels[0].last, 1.0);
    EXPECT_EQ(pixels[1].first, 2.0);
    EXPECT_EQ(pixels[2].pixel, 30);
    EXPECT_TRUE(pixels[3].gapBefore) << "another run begins";
    EXPECT_EQ(pixels[4].first, 6.0);
}

TEST(Reduction, OfNothingIsNothing) {
    const auto table = tableOf("time_s,a,event\n0,,x\n1,,y\n");
    EXPECT_TRUE(reduceToPixels(table->columns()[1], table->time(), {0.0, 1.0, 100}).empty());
    EXPECT_TRUE(reduceToPixels(table->columns()[2], table->time(), {0.0, 1.0, 100}).empty());
    EXPECT_TRUE(reduceToPixels(table->columns()[1], table->time(), {0.0, 0.0, 100}).empty());
    EXPECT_TRUE(reduceToPixels(tableOf("time_s,a\n")->columns()[1], tableOf("time_s,a\n")->time(), {0, 1, 9})
                    .empty());
}

TEST(TimeAxis, FindsRowsByTime) {
    const auto table = tableOf("time_s,a\n1,1\n2,2\n,3\n4,4\n4,5\n5,6\n");
    const TimeAxis& time = table->time();
    const TimeAxis::Run all{0, time.rowCount()};
    EXPECT_EQ(time.firstAtOrAfter(all, 0.0), 0U);
    EXPECT_EQ(time.firstAtOrAfter(all, 4.0), 2U) << "the one without a time before it";
    EXPECT_EQ(time.firstAfter(all, 4.0), 5U);
    EXPECT_EQ(time.firstAfter(all, 9.0), 6U);
    EXPECT_EQ(time.lastAtOrBefore(3.0), Row{1});
    EXPECT_EQ(time.lastAtOrBefore(4.0), Row{4});
    EXPECT_EQ(time.lastAtOrBefore(0.5), std::nullopt);
    EXPECT_EQ(time.begin(), 1.0);
    EXPECT_EQ(time.end(), 5.0);
    EXPECT_TRUE(std::isnan(time.seconds(2)));
}

} // namespace
} // namespace hexapose
