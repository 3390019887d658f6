// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_layout.h"

#include <QImage>

#include <gtest/gtest.h>

#include <limits>

namespace hexapose {
namespace {

constexpr QRectF kArea(0.0, 0.0, 600.0, 240.0);

class PlotTimesTest : public ::testing::Test {
protected:
    PlotTimesTest() : style(paperStyle(1.0)) {
        plot.x = {0.0, 10.0, 2.0};
        plot.y = {0.0, 1.0};
    }
    QImage draw() const {
        QImage image(kArea.size().toSize(), QImage::Format_RGB32);
        image.fill(style.ground);
        QPainter painter(&image);
        paintPlot(painter, kArea, plot, style);
        return image;
    }
    QColor at(const QImage& image, double x, double y) const {
        return image.pixelColor(layOutPlot(plot, kArea, style, image).scale.at(x, y).toPoint());
    }
    PlotStyle style;
    Plot plot;
};

TEST_F(PlotTimesTest, ASpanIsShadedFromItsBeginToItsEnd) {
    plot.spans = {{2.0, 4.0, QStringLiteral("moving"), Qt::yellow}};
    const QImage image = draw();
    EXPECT_EQ(at(image, 3.0, 0.9), QColor(Qt::yellow));
    EXPECT_EQ(at(image, 1.0, 0.9), style.ground);
    EXPECT_EQ(at(image, 5.0, 0.9), style.ground);
}

TEST_F(PlotTimesTest, ASpanBeyondTheFrameEndsThere) {
    plot.spans = {{-5.0, 50.0, {}, Qt::yellow}};
    const QImage image = draw();
    const QRectF frame = layOutPlot(plot, kArea, style, image).scale.frame;
    EXPECT_EQ(at(image, 9.5, 0.9), QColor(Qt::yellow));
    EXPECT_EQ(image.pixelColor(static_cast<int>(frame.right()) + 5, static_cast<int>(frame.center().y())),
              style.ground);
}

TEST_F(PlotTimesTest, AnInstantHasItsTextWhereThereIsRoom) {
    plot.instants = {{2.0, {}}, {2.1, {}}};
    const QImage lines = draw();
    plot.instants[0].label = QStringLiteral("hidden by the next one");
    EXPECT_EQ(draw(), lines);
    plot.instants[1].label = QStringLiteral("told");
    EXPECT_NE(draw(), lines);
}

TEST_F(PlotTimesTest, PlotsAgreeOnTheirLeft) {
    const QImage device(1, 1, QImage::Format_RGB32);
    plot.leastLeft = 120.0;
    EXPECT_NEAR(layOutPlot(plot, kArea, style, device).scale.frame.left(), 120.0, 1.0);
    plot.leastLeft = 0.0;
    EXPECT_LT(layOutPlot(plot, kArea, style, device).scale.frame.left(), 100.0);
}

TEST_F(PlotTimesTest, AReducedCurveIsDrawnWithItsGaps) {
    Plot::Series series;
    series.colour = Qt::red;
    series.marker = Plot::Marker::None;
    series.isReduced = true;
    series.points = {
        {1.0, 0.5}, {4.0, 0.5}, {4.0, std::numeric_limits<double>::quiet_NaN()}, {6.0, 0.5}, {9.0, 0.5}};
    plot.series = {series};
    const QImage image = draw();
    EXPECT_GT(at(image, 2.5, 0.5).red(), at(image, 2.5, 0.5).green() + 60);
    EXPECT_NEAR(at(image, 5.0, 0.5).red(), at(image, 5.0, 0.5).green(), 10);
    EXPECT_GT(at(image, 7.5, 0.5).red(), at(image, 7.5, 0.5).green() + 60);
}

TEST(RoomyRange, HasRoomForAnyNumbers) {
    const double large = std::numeric_limits<double>::max();
    for (const auto& [low, high] : std::vector<std::pair<double, double>>{{-large, large},
                                                                          {0.0, 0.0},
                                                                          {7.25, 7.25},
                                                                          {-0.0, 5e-324},
                                                                          {1e6, 1e6 + 1e-9},
                                                                          {1e-310, 2e-310},
                                                                          {1e300, 1e300}}) {
        const AxisRange range = roomyRange(std::pair(low, high));
        EXPECT_LT(range.low, range.high) << low << " " << high;
        EXPECT_FALSE(niceTicks(range, 5).values.empty()) << low << " " << high;
    }
}

} // namespace
} // namespace hexapose
