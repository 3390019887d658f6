// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/viewer/temporary_log.h"
#include "ui/viewer/log_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hexapose {
namespace {

using testing::logText;
using testing::TemporaryLog;

class LogPlotTest : public ::testing::Test {
protected:
    LogPlotTest() : log(logText(20000)), table(log.table()) {
        CurveFinder finder;
        finder.follow(table);
        source.table = table;
        source.chart = {QStringLiteral("a"), {{QStringLiteral("a"), {}}}};
        source.curves = finder.find(source.chart);
    }
    Plot draw(const TimeSpan& view, int pixels) const {
        Plot plot = emptyLogPlot(source, view, std::nullopt);
        fillLogPlot(plot, source, view, pixels);
        return plot;
    }
    /// By a search through all rows.
    MinMax bruteForce(double from, double to) const {
        MinMax all;
        for (Row row = 0; row < table->rowCount(); ++row)
            if (const double time = table->time().seconds(row); time >= from && time <= to)
                all.add(source.curves[0].column->number(row));
        return all;
    }
    TemporaryLog log;
    std::shared_ptr<const Table> table;
    LogPlotSource source;
};

TEST_F(LogPlotTest, TheExtremesDrawnAreThoseOfAllRows) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, 200.0);
    for (int i = 0; i < 100; ++i) {
        const double one = place(random), other = place(random);
        const TimeSpan view{std::min(one, other), std::max(one, other) + 0.02};
        MinMax drawn;
        const Plot plot = draw(view, 320);
        for (const QPointF& point : plot.series.at(0).points)
            if (point.x() >= view.begin && point.x() <= view.end && std::isfinite(point.y()))
                drawn.add(point.y());
        EXPECT_EQ(drawn, bruteForce(view.begin, view.end)) << view.begin << " " << view.end;
    }
}

TEST_F(LogPlotTest, TheSpikeIsInTheWholeViewAndOnTheAxis) {
    const Plot plot = draw({0.0, 199.99}, 300);
    EXPECT_GT(plot.y.high, 100.0);
    EXPECT_LE(plot.series.at(0).points.size(), 5U * 302U);
}

TEST_F(LogPlotTest, AMissingCellIsAGap) {
    const TemporaryLog gap("time_s,a\n0,1\n1,2\n2,\n3,4\n4,5\n");
    source.table = gap.table();
    CurveFinder finder;
    finder.follow(source.table);
    source.curves = finder.find(source.chart);
    const Plot plot = draw({0.0, 4.0}, 400);
    int gaps = 0;
    for (const QPointF& point : plot.series.at(0).points)
        gaps += std::isnan(point.y()) ? 1 : 0;
    EXPECT_EQ(gaps, 1);
}

TEST_F(LogPlotTest, TheLargestNumbersHaveAnAxis) {
    const TemporaryLog large("time_s,a\n0,1e308\n1,-1e308\n2,1e308\n");
    source.table = large.table();
    CurveFinder finder;
    finder.follow(source.table);
    source.curves = finder.find(source.chart);
    const Plot plot = draw({0.0, 2.0}, 400);
    EXPECT_TRUE(std::isfinite(plot.y.low) && std::isfinite(plot.y.high));
    EXPECT_LT(plot.y.low, -1e308);
    EXPECT_GT(plot.y.high, 1e308);
    EXPECT_GE(niceTicks(plot.y, 5).values.size(), 2U);
}

TEST_F(LogPlotTest, SmallStepsOfALargeNumberAreTold) {
    const AxisRange range = roomyRange(std::pair(1e6, 1e6 + 4e-6));
    const Ticks ticks = niceTicks(range, 5);
    ASSERT_GE(ticks.labels.size(), 2U);
    EXPECT_NE(ticks.labels.front(), ticks.labels.back());
    EXPECT_EQ(ticks.exponent, 0);
    EXPECT_TRUE(ticks.labels.front().startsWith(QStringLiteral("1000000.00000")))
        << ticks.labels.front().toStdString();
}

TEST_F(LogPlotTest, WhatIsNotInTheLogIsSaid) {
    source.curves.clear();
    EXPECT_FALSE(emptyLogPlot(source, {0.0, 1.0}, std::nullopt).note.isEmpty());
}

} // namespace
} // namespace hexapose
