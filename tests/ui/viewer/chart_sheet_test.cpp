// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/viewer/temporary_log.h"
#include "ui/viewer/chart_sheet.h"

#include <QMimeData>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include <cmath>

namespace hexapose {
namespace {

using testing::logText;
using testing::TemporaryLog;

class ChartSheetTest : public ::testing::Test {
protected:
    ChartSheetTest() : log(logText(4000)) {
        sheet.resize(700, 400);
        sheet.setTable(log.table());
        sheet.setChartLayout(
            {{{QStringLiteral("one"), {{QStringLiteral("a"), {}}}}, {QStringLiteral("two"), {}}}});
        sheet.show();
        sheet.grab(); // laid out and drawn
    }
    QPoint placeOf(double time, double down = 0.5) {
        const PlotScale scale = sheet.chart(0).layOut().scale;
        return QPointF(scale.at(time, 0.0).x(), scale.frame.top() + down * scale.frame.height()).toPoint();
    }
    double timeAt(QPoint place) { return sheet.chart(0).layOut().scale.xAt(place.x()); }
    void turnWheel(int notches, QPoint at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QWheelEvent event(at, sheet.chart(0).mapToGlobal(QPointF(at)), {}, {0, 120 * notches}, Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&sheet.chart(0), &event);
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mousePress(&sheet.chart(0), Qt::LeftButton, modifiers, from);
        QMouseEvent move(QEvent::MouseMove, to, sheet.chart(0).mapToGlobal(QPointF(to)), Qt::NoButton,
                         Qt::LeftButton, modifiers);
        QApplication::sendEvent(&sheet.chart(0), &move);
        QTest::mouseRelease(&sheet.chart(0), Qt::LeftButton, modifiers, to);
    }
    TemporaryLog log;
    ChartSheet sheet;
};

constexpr double kPixelSlack = 0.2; // s, a few pixels

TEST_F(ChartSheetTest, ShowsEverythingAtFirst) {
    EXPECT_DOUBLE_EQ(sheet.time().begin, 0.0);
    EXPECT_DOUBLE_EQ(sheet.time().end, 39.99);
}

TEST_F(ChartSheetTest, AllChartsHaveOneTimeAndOneLeftMargin) {
    const PlotScale one = sheet.chart(0).layOut().scale, two = sheet.chart(1).layOut().scale;
    EXPECT_EQ(one.frame.left(), two.frame.left());
    EXPECT_EQ(one.x, two.x);
    sheet.showTime({3.0, 4.0});
    EXPECT_EQ(sheet.chart(1).layOut().scale.x, sheet.chart(0).layOut().scale.x);
}

TEST_F(ChartSheetTest, TheWheelZoomsAboutThePointer) {
    const QPoint at = placeOf(10.0);
    const double before = timeAt(at);
    turnWheel(3, at);
    EXPECT_LT(sheet.time().length(), 25.0);
    EXPECT_NEAR(timeAt(at), before, 1e-6);
    turnWheel(2, at);
    sheet.goBack(); // the burst as a whole
    EXPECT_DOUBLE_EQ(sheet.time().end, 39.99);
    sheet.goForward();
    EXPECT_LT(sheet.time().length(), 20.0);
}

TEST_F(ChartSheetTest, TheWheelZoomsValuesWithControlAndMovesWithShift) {
    turnWheel(2, placeOf(10.0), Qt::ControlModifier);
    EXPECT_EQ(sheet.view().values.size(), 1U);
    EXPECT_DOUBLE_EQ(sheet.time().length(), 39.99);
    sheet.showTime({10.0, 20.0});
    turnWheel(-1, placeOf(15.0), Qt::ShiftModifier);
    EXPECT_DOUBLE_EQ(sheet.time().begin, 11.0);
    EXPECT_DOUBLE_EQ(sheet.time().end, 21.0);
}

TEST_F(ChartSheetTest, AFlatBoxZoomsTimeATallOneValuesToo) {
    drag(placeOf(10.0), placeOf(20.0));
    EXPECT_NEAR(sheet.time().begin, 10.0, kPixelSlack);
    EXPECT_NEAR(sheet.time().end, 20.0, kPixelSlack);
    EXPECT_TRUE(sheet.view().values.empty());
    sheet.fit();
    drag(placeOf(10.0, 0.1), placeOf(20.0, 0.9));
    EXPECT_EQ(sheet.view().values.size(), 1U);
    sheet.fit();
    EXPECT_TRUE(sheet.view().values.empty());
}

TEST_F(ChartSheetTest, ShiftAndDragMoves) {
    sheet.showTime({10.0, 20.0});
    drag(placeOf(15.0), placeOf(13.0), Qt::ShiftModifier);
    EXPECT_NEAR(sheet.time().begin, 12.0, kPixelSlack);
    EXPECT_NEAR(sheet.time().length(), 10.0, 1e-9);
}

TEST_F(ChartSheetTest, AClickSetsCursorAWithControlB) {
    QTest::mouseClick(&sheet.chart(0), Qt::LeftButton, Qt::NoModifier, placeOf(10.0));
    QTest::mouseClick(&sheet.chart(0), Qt::LeftButton, Qt::ControlModifier, placeOf(20.0));
    ASSERT_TRUE(sheet.cursors().a && sheet.cursors().b);
    EXPECT_NEAR(*sheet.cursors().a, 10.0, kPixelSlack);
    EXPECT_NEAR(*sheet.cursors().b, 20.0, kPixelSlack);
    drag(placeOf(*sheet.cursors().b), placeOf(30.0)); // it is taken along
    EXPECT_NEAR(*sheet.cursors().b, 30.0, kPixelSlack);
    EXPECT_DOUBLE_EQ(sheet.time().length(), 39.99);
}

TEST_F(ChartSheetTest, KeysMoveZoomAndSetCursors) {
    LogChart& chart = sheet.chart(0);
    QTest::keyClick(&chart, Qt::Key_Plus);
    EXPECT_NEAR(sheet.time().length(), 20.0, 0.1);
    const double begin = sheet.time().begin;
    QTest::keyClick(&chart, Qt::Key_Right);
    EXPECT_GT(sheet.time().begin, begin);
    QTest::keyClick(&chart, Qt::Key_Home);
    EXPECT_DOUBLE_EQ(sheet.time().length(), 39.99);
    QTest::keyClick(&chart, Qt::Key_A);
    ASSERT_TRUE(sheet.cursors().a);
    const double a = *sheet.cursors().a;
    QTest::keyClick(&chart, Qt::Key_Right, Qt::ControlModifier);
    EXPECT_NEAR(*sheet.cursors().a, a, 0.011); // to the next row
    EXPECT_GT(*sheet.cursors().a, a);
    QTest::keyClick(&chart, Qt::Key_Escape);
    EXPECT_FALSE(sheet.cursors().a);
}

TEST_F(ChartSheetTest, ZoomsToTheDistanceOfRowsAndNoFurther) {
    for (int i = 0; i < 200; ++i)
        sheet.zoom(0.5, 10.0);
    EXPECT_GT(sheet.time().length(), 0.0);
    EXPECT_LT(sheet.time().length(), 0.01);
    sheet.grab();
    for (int i = 0; i < 200; ++i)
        sheet.zoom(2.0, 10.0);
    EXPECT_LT(sheet.time().length(), 130.0);
    sheet.grab();
}

TEST_F(ChartSheetTest, ColumnsAreDroppedOntoAChart) {
    QMimeData data;
    data.setData(QString::fromLatin1(kColumnsMime), "a");
    testing::drop(sheet.chart(1), data);
    ASSERT_EQ(sheet.chartLayout().charts[1].curves.size(), 1U);
    sheet.removeCurve(1, {QStringLiteral("a"), {}});
    EXPECT_TRUE(sheet.chartLayout().charts[1].curves.empty());
    sheet.addChart({{}, {{QStringLiteral("a"), {}}}});
    EXPECT_EQ(sheet.chartCount(), 3U);
    sheet.removeChart(0);
    EXPECT_EQ(sheet.chartCount(), 2U);
}

TEST_F(ChartSheetTest, TheViewOfTheUserStaysWhenMoreIsRead) {
    sheet.showTime({3.0, 4.0});
    const TemporaryLog more(logText(5000));
    sheet.setTable(more.table());
    EXPECT_EQ(sheet.time(), (TimeSpan{3.0, 4.0}));
    sheet.fit();
    EXPECT_DOUBLE_EQ(sheet.time().end, 49.99);
}

} // namespace
} // namespace hexapose
