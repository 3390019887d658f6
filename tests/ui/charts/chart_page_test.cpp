// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/geometry_file.h"
#include "tests/ui/screen_reader.h"
#include "ui/charts/chart_page.h"
#include "ui/plot/plot_curve.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>

namespace hexapose {
namespace {

using testing::findByName;

class ChartPageTest : public ::testing::Test {
protected:
    ChartPageTest()
        : page(makeModel(loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml"))) {
        page.resize(900, 450);
        page.show();
    }

    void feed(double from, double to, double x, bool stale = false) {
        for (double t = from; t < to; t += 0.01) {
            Snapshot snapshot;
            snapshot.time = std::chrono::nanoseconds(static_cast<std::int64_t>(t * 1e9));
            snapshot.fresh = !stale;
            snapshot.stale = stale;
            snapshot.measuredPose = Pose{{x, 0.0, 0.0}, {}};
            snapshot.targetPose = Pose{{0.012, 0.0, 0.0}, {}};
            snapshot.measuredLengths = LegLengths::Constant(0.300);
            snapshot.commandedLengths = LegLengths::Constant(0.301);
            page.add(snapshot);
        }
        page.refresh(to);
    }
    void press(const char* name) {
        auto* button = qobject_cast<QPushButton*>(findByName(page, QString::fromLatin1(name)));
        ASSERT_NE(button, nullptr) << name;
        button->click();
    }

    ChartPage page;
};

TEST_F(ChartPageTest, ShowsTheSixCoordinatesThenLegsThenErrors) {
    feed(0.0, 1.0, 0.010);
    EXPECT_EQ(page.charts()[0]->subject().unit, "mm");
    EXPECT_EQ(page.charts()[5]->subject().unit, QString::fromUtf8("\u00b0"));
    EXPECT_TRUE(page.charts()[0]->subject().target);
    EXPECT_EQ(page.charts()[0]->verticalRange(), (AxisRange{-40.0, 40.0, 20.0}));
    EXPECT_EQ(page.charts()[3]->verticalRange(), (AxisRange{-10.0, 10.0, 5.0}));
    const auto shown = [this](std::size_t chart) {
        return page.history().valueAt(page.charts()[chart]->subject().measured, 0.5);
    };
    const auto legendHas = [this](const char* word) {
        const auto labels = page.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [word](const QLabel* label) {
            return label->text().endsWith(QLatin1String(word));
        });
    };
    constexpr double kRounding = 1e-9;
    EXPECT_NEAR(shown(0), 10.0, kRounding);
    EXPECT_TRUE(legendHas("path"));
    press("Legs");
    EXPECT_TRUE(legendHas("set-point"));
    EXPECT_NEAR(shown(5), 300.0, kRounding);
    EXPECT_EQ(page.charts()[5]->verticalRange(), (AxisRange{250.0, 350.0, 50.0}));
    press("Errors");
    EXPECT_NEAR(shown(0), -2.0, kRounding);
    EXPECT_FALSE(page.charts()[0]->subject().target);
    press("Pose");
    EXPECT_NEAR(shown(0), 10.0, kRounding);
}

TEST_F(ChartPageTest, StaleDataLeavesAGapAndIsNeverDrawn) {
    feed(0.0, 1.0, 0.010);
    feed(1.0, 2.0, 0.099, true);
    feed(2.0, 3.0, 0.010);
    const PlotScale scale{QRectF(0.0, 0.0, 1.0, 1.0), {0.0, 1.0}, {0.0, 1.0}};
    EXPECT_EQ(curvePieces(page.history().curve(0, 0.0, 10.0), scale, 1e-9).size(), 2U);
    EXPECT_LT(page.history().range(0, 0.0, 10.0)->second, 11.0);
}

TEST_F(ChartPageTest, GrowsWhenDataLeavesTheRangeAndComesBack) {
    feed(0.0, 1.0, 0.070);
    EXPECT_EQ(page.charts()[0]->verticalRange().high, 100.0);
    feed(1.0, 14.0, 0.0);
    EXPECT_EQ(page.charts()[0]->verticalRange().high, 40.0);
}

TEST_F(ChartPageTest, DrawsInTurnSoThatAKeyNeedNotWaitForAll) {
    feed(0.0, 1.0, 0.010);
    Snapshot turned;
    turned.time = std::chrono::milliseconds(1010);
    turned.fresh = true;
    turned.stale = false;
    turned.measuredPose = Pose{{0.055, 0.0, 0.0}, {0.0, 0.0, 0.5}};
    page.add(turned);
    page.refreshInTurn(1.02);
    const auto gamma = [this] { return page.charts()[5]->verticalRange(); };
    EXPECT_GT(page.charts()[0]->verticalRange().high, 40.0) << "the first at once";
    EXPECT_EQ(gamma(), (AxisRange{-10.0, 10.0, 5.0})) << "the last not yet";
    constexpr int kPatienceMs = 20000;
    EXPECT_TRUE(QTest::qWaitFor([&] { return gamma().high > 10.0; }, kPatienceMs));
}

TEST_F(ChartPageTest, PauseHoldsThePictureWhileRecordingGoesOn) {
    feed(0.0, 1.0, 0.010);
    press("Pause");
    feed(1.0, 2.0, 0.070);
    EXPECT_TRUE(page.isPaused());
    EXPECT_EQ(page.charts()[0]->verticalRange().high, 40.0);
    press("Resume");
    page.refresh(2.0);
    EXPECT_EQ(page.charts()[0]->verticalRange().high, 100.0);
}

TEST_F(ChartPageTest, ZoomChangesTheWindowOfAllCharts) {
    feed(0.0, 1.0, 0.010);
    EXPECT_EQ(page.window(), 10.0);
    press("Shorter time window");
    EXPECT_EQ(page.window(), 5.0);
    emit page.charts()[2]->zoomed(100.0);
    EXPECT_EQ(page.window(), 120.0);
}

} // namespace
} // namespace hexapose
