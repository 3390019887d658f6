// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/time_chart.h"

#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>

namespace hexapose {
namespace {

constexpr double kFrom = 0.0;
constexpr double kTo = 10.0;

class TimeChartTest : public ::testing::Test {
protected:
    TimeChartTest() : history(2) {
        chart.resize(420, 260);
        chart.setSubject({QStringLiteral("x"), QStringLiteral("mm"), 0, 1, -40.0, 40.0, 3});
        chart.setTimeTitle(QStringLiteral("Time, s"));
        chart.show();
    }

    void feed(double from, double to, double measured, double target) {
        for (double t = from; t < to; t += 0.01)
            history.add(t, {measured, target});
    }
    QImage picture() {
        chart.showWindow(history, kFrom, kTo);
        QImage image(chart.size(), QImage::Format_RGB32);
        image.fill(Qt::magenta); // nothing of the theme
        chart.render(&image);
        return image;
    }
    /// Whether that colour, or nearly, is in the column of pixels at a time, within the frame.
    bool showsAt(const QImage& image, double time, const QColor& colour) const {
        const PlotScale scale = chart.layOut().scale;
        const int x = static_cast<int>(std::floor(scale.at(time, 0.0).x()));
        const int bottom = static_cast<int>(scale.frame.bottom());
        for (int y = static_cast<int>(scale.frame.top()) + 1; y < bottom; ++y)
            if (isNear(image.pixelColor(x, y), colour))
                return true;
        return false;
    }
    static bool isNear(const QColor& a, const QColor& b) {
        constexpr int kNear = 60; // of a line that lies between two pixels
        return std::abs(a.red() - b.red()) < kNear && std::abs(a.green() - b.green()) < kNear &&
               std::abs(a.blue() - b.blue()) < kNear;
    }

    ChartHistory history;
    TimeChart chart;
};

TEST_F(TimeChartTest, AGapIsNotBridged) {
    feed(0.0, 3.0, 10.0, 30.0);
    history.addGap();
    feed(7.0, 10.0, -10.0, -30.0);
    const QImage image = picture();
    const QColor accent = themeColors(ThemeKind::Light).accent;
    for (const double time : {1.3, 2.7, 7.3, 9.3})
        EXPECT_TRUE(showsAt(image, time, accent)) << time;
    for (const double time : {3.3, 5.0, 6.7})
        EXPECT_FALSE(showsAt(image, time, accent)) << time;
}

TEST_F(TimeChartTest, HasTheColoursOfItsTheme) {
    for (int i = 0; i < 1000; ++i) // dense enough to fill an area, so that the colours are pure
        history.add(i * 0.01, {i % 2 == 0 ? 5.0 : 15.0, i % 2 == 0 ? -5.0 : -35.0});
    for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark}) {
        const ThemeColors colors = themeColors(kind);
        chart.setColors(colors);
        const QImage image = picture();
        const PlotScale scale = chart.layOut().scale;
        const auto pixel = [&](double time, double value) {
            return image.pixelColor(scale.at(time, value).toPoint());
        };
        EXPECT_EQ(pixel(5.1, 10.0), colors.accent);
        EXPECT_EQ(pixel(5.1, 27.0), colors.surface);
        EXPECT_EQ(image.pixelColor(8, image.height() / 4), colors.surface) << "around the frame";
        bool targetShown = false;
        for (double time = 4.0; time < 6.0; time += 0.02)
            targetShown = targetShown || isNear(pixel(time, -20.5), colors.muted);
        EXPECT_TRUE(targetShown);
        std::set<QRgb> seen;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                seen.insert(image.pixel(x, y));
        for (const QColor& color : {colors.text, colors.border})
            EXPECT_EQ(seen.count(color.rgb()), 1U) << qPrintable(color.name());
        if (kind == ThemeKind::Dark) {
            EXPECT_EQ(seen.count(QColor(Qt::white).rgb()), 0U) << "nothing of the paper";
        }
    }
}

TEST_F(TimeChartTest, HasTheTicksThatPaperHas) {
    feed(0.0, 10.0, 57.0, -12.0);
    for (const QSize size : {QSize(420, 260), QSize(900, 330), QSize(300, 200)}) {
        chart.resize(size);
        const QImage paper = picture();
        const PlotLayout screen = chart.layOut();
        const PlotLayout printed = layOutPlot(chart.plot(), QRectF(QPointF(), size), paperStyle(1.0), paper);
        EXPECT_EQ(screen.xTicks.labels, printed.xTicks.labels);
        EXPECT_EQ(screen.yTicks.labels, printed.yTicks.labels);
        EXPECT_EQ(screen.yTicks.values, printed.yTicks.values);
        EXPECT_EQ(screen.yTicks.labels, (std::vector<QString>{"-50", "0", "50", "100"}));
    }
}

TEST_F(TimeChartTest, IsPaintedWhenSomethingChangesAndNotElse) {
    struct Counter : QObject {
        int paints = 0;
        bool eventFilter(QObject* watched, QEvent* event) override {
            paints += event->type() == QEvent::Paint ? 1 : 0;
            return QObject::eventFilter(watched, event);
        }
    } counter;
    feed(0.0, 3.0, 10.0, 30.0);
    history.addGap();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&chart));
    chart.showWindow(history, kFrom, kTo);
    QCoreApplication::processEvents();
    chart.installEventFilter(&counter);
    chart.showWindow(history, kFrom, kTo);
    chart.showCursor(history, std::nullopt);
    QCoreApplication::processEvents();
    EXPECT_EQ(counter.paints, 0);
    history.add(8.0, {1.0, 1.0});
    chart.showWindow(history, kFrom, kTo);
    QCoreApplication::processEvents();
    EXPECT_EQ(counter.paints, 1);
    chart.showCursor(history, 2.0);
    QCoreApplication::processEvents();
    EXPECT_EQ(counter.paints, 2);
}

TEST_F(TimeChartTest, TheReadOutStaysWithinTheFrame) {
    feed(0.0, 10.0, -39.123, -30.456);
    for (const QSize size : {QSize(420, 260), QSize(220, 150)}) {
        chart.resize(size);
        chart.showCursor(history, std::nullopt);
        const QImage without = picture();
        const PlotScale scale = chart.layOut().scale;
        for (const double time : {0.4, 5.0, 9.6}) {
            chart.showCursor(history, time);
            const QImage with = picture();
            QRect changed;
            for (int y = 0; y < with.height(); ++y)
                for (int x = 0; x < with.width(); ++x)
                    if (with.pixel(x, y) != without.pixel(x, y))
                        changed |= QRect(x, y, 1, 1);
            EXPECT_GT(changed.width(), 20) << "a read-out is shown";
            EXPECT_TRUE(scale.frame.adjusted(-1.0, -1.0, 1.0, 1.0).contains(changed)) << size.width();
        }
    }
}

TEST_F(TimeChartTest, TellsTheTimeUnderTheMouse) {
    feed(0.0, 10.0, 10.0, 30.0);
    chart.showWindow(history, kFrom, kTo);
    const QSignalSpy moved(&chart, &TimeChart::cursorMoved);
    const QSignalSpy left(&chart, &TimeChart::cursorLeft);
    const PlotScale scale = chart.layOut().scale;
    const double pixel = (kTo - kFrom) / scale.frame.width();
    QTest::mouseMove(&chart, scale.at(2.5, 0.0).toPoint());
    ASSERT_EQ(moved.count(), 1);
    EXPECT_NEAR(moved[0][0].toDouble(), 2.5, pixel);
    QTest::mouseMove(&chart, QPoint(2, 2));
    EXPECT_EQ(moved.count(), 1);
    EXPECT_GE(left.count(), 1);
}

} // namespace
} // namespace hexapose
