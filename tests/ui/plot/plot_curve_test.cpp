// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/picture_files.h"
#include "ui/plot/plot_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

namespace hexapose {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kWidth = 300.0;

PlotScale scaleOf(double seconds) {
    return {QRectF(20.0, 10.0, kWidth, 150.0), {0.0, seconds}, {-5.0, 5.0}};
}

struct Extremes {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    bool operator==(const Extremes&) const = default;

    void add(double y) {
        low = std::min(low, y);
        high = std::max(high, y);
    }
};
/// Of each piece and column.
using Columns = std::map<std::pair<std::size_t, double>, Extremes>;

/// By the definition, from all points.
Columns bruteForce(const std::vector<QPointF>& points, const PlotScale& scale, double column) {
    Columns columns;
    std::size_t piece = 0;
    bool broken = false;
    for (const QPointF& point : points) {
        if (!std::isfinite(point.y())) {
            broken = true;
            continue;
        }
        piece += broken && !columns.empty() ? 1U : 0U;
        broken = false;
        const QPointF at = scale.at(point.x(), point.y());
        columns[{piece, std::floor(at.x() / column)}].add(at.y());
    }
    return columns;
}

Columns columnsOf(const CurvePieces& pieces, double column) {
    Columns columns;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (const QPointF& at : pieces[i])
            columns[{i, std::floor(at.x() / column)}].add(at.y());
    return columns;
}

std::vector<QPointF> wander(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<QPointF> points;
    double y = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        y = 0.99 * y + 0.3 * normal(random);
        points.emplace_back(static_cast<double>(i), random() % 97 == 0 ? kNaN : y);
    }
    return points;
}

TEST(PlotCurve, ExtremesOfEveryColumnAreThoseOfAllPoints) {
    for (const std::size_t count : {1U, 2U, 50U, 301U, 5000U, 40000U})
        for (const double column : {1.0, 0.5, 0.25}) {
            const std::vector<QPointF> points = wander(count, count);
            const PlotScale scale = scaleOf(static_cast<double>(count));
            const CurvePieces pieces = curvePieces(points, scale, column);
            EXPECT_EQ(columnsOf(pieces, column), bruteForce(points, scale, column))
                << count << " points in columns of " << column;
            const auto byX = [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); };
            for (const QPolygonF& piece : pieces)
                EXPECT_TRUE(std::is_sorted(piece.begin(), piece.end(), byX)) << "in the order of the curve";
        }
}

TEST(PlotCurve, AMillionPointsAreDrawnAsAFew) {
    std::vector<QPointF> points;
    for (int i = 0; i <= 1000000; ++i)
        points.emplace_back(i, std::sin(i * 0.37) * 4.0);
    const CurvePieces pieces = curvePieces(points, scaleOf(1e6), 1.0);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_LE(pieces[0].size(), 2 * static_cast<qsizetype>(kWidth) + 4);
    EXPECT_EQ(pieces[0].front(), scaleOf(1e6).at(0.0, points.front().y()));
    EXPECT_EQ(pieces[0].back(), scaleOf(1e6).at(1e6, points.back().y())) << "the ends stay";

    Plot plot;
    plot.x = {0.0, 1e6};
    plot.y = {-5.0, 5.0};
    plot.series.push_back({"curve", Qt::blue, Plot::Marker::None, true, points});
    const QByteArray svg = svgBytes(QSize(900, 330), {}, {}, [&](QPainter& painter) {
        paintPlot(painter, QRectF(0.0, 0.0, 900.0, 330.0), plot, paperStyle(1.0));
    });
    EXPECT_LT(svg.size(), 500000) << "on paper as well";
    EXPECT_GT(svg.size(), 10000);
}

TEST(PlotCurve, FewPointsAreLeftAsTheyAre) {
    const std::vector<QPointF> points{{0.0, 1.0}, {1.0, 2.0},  {1.0, -2.0},
                                      {0.5, 0.0}, {3.0, kNaN}, {3.0, 1.0}};
    const CurvePieces pieces = curvePieces(points, scaleOf(4.0), 0.25);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].size(), 4) << "also where the curve turns back";
    EXPECT_EQ(pieces[1].size(), 1);
}

} // namespace
} // namespace hexapose
