// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart_history.h"
#include "ui/plot/plot_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapose {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::size_t points(const CurvePieces& pieces) {
    std::size_t count = 0;
    for (const auto& piece : pieces) {
        count += static_cast<std::size_t>(piece.size());
    }
    return count;
}

/// As it is drawn where a unit of time and of value is a pixel, in columns of that width.
CurvePieces drawn(const std::vector<QPointF>& curve, double column = 1e-9) {
    return curvePieces(curve, {QRectF(0.0, -1.0, 1.0, 1.0), {0.0, 1.0}, {0.0, 1.0}}, column);
}

TEST(ChartHistory, KeepsTheNewestAndForgetsTheOldest) {
    ChartHistory history(2, 4);
    for (int i = 0; i < 10; ++i) {
        history.add(i, {i * 1.0, -i * 1.0});
    }
    EXPECT_EQ(history.size(), 4U);
    EXPECT_EQ(history.lastTime(), 9.0);
    const std::vector<QPointF> curve = history.curve(1, 0.0, 100.0);
    ASSERT_EQ(curve.size(), 4U);
    EXPECT_EQ(curve.front(), QPointF(6.0, -6.0));
    EXPECT_EQ(curve.back(), QPointF(9.0, -9.0));
    EXPECT_EQ(drawn(curve).size(), 1U);
    EXPECT_EQ(history.valueAt(0, 7.5), 7.0);
    EXPECT_TRUE(std::isnan(history.valueAt(0, 5.0)));
    history.add(3.0, {1.0, 1.0}); // back in time
    history.add(20.0, {1.0});     // another number of channels
    EXPECT_EQ(history.lastTime(), 9.0);
}

TEST(ChartHistory, BreaksTheCurveAtAGapAndAtANaN) {
    ChartHistory history(1);
    history.add(0.0, {1.0});
    history.add(1.0, {2.0});
    history.addGap();
    history.add(5.0, {3.0});
    history.add(6.0, {kNaN});
    history.add(7.0, {4.0});
    const CurvePieces curve = drawn(history.curve(0, 0.0, 10.0));
    ASSERT_EQ(curve.size(), 3U);
    EXPECT_EQ(curve[0].size(), 2U);
    EXPECT_EQ(curve[1].size(), 1U);
    EXPECT_EQ(curve[2].front(), QPointF(7.0, -4.0)) << "upwards";
    EXPECT_EQ(history.range(0, 0.0, 10.0), std::pair(1.0, 4.0));
    EXPECT_FALSE(history.range(0, 8.0, 10.0));
    EXPECT_TRUE(ChartHistory(1).curve(0, 0.0, 1.0).empty());
}

TEST(ChartHistory, ThinningKeepsEveryPeak) {
    constexpr std::size_t kColumns = 200;
    ChartHistory history(1);
    for (int i = 0; i < 10000; ++i) {
        history.add(i * 0.001, {i == 4321 ? 50.0 : i == 7777 ? -50.0 : std::sin(i * 0.01)});
    }
    const CurvePieces curve = drawn(history.curve(0, 0.0, 10.0), 10.0 / kColumns);
    EXPECT_LE(points(curve), 2 * kColumns + 4);
    EXPECT_GE(points(curve), kColumns);
    const auto byY = [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); };
    const auto byX = [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); };
    const auto [low, high] = std::minmax_element(curve[0].begin(), curve[0].end(), byY);
    EXPECT_EQ(*low, QPointF(4321 * 0.001, -50.0)) << "the peak, upwards";
    EXPECT_EQ(*high, QPointF(7777 * 0.001, 50.0));
    EXPECT_TRUE(std::is_sorted(curve[0].begin(), curve[0].end(), byX));
}

} // namespace
} // namespace hexapose
