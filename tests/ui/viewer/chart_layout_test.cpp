// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/input_error.h"
#include "tests/ui/viewer/temporary_log.h"
#include "ui/viewer/chart_layout.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using testing::TemporaryLog;

QStringList names(const ChartSpec& chart) {
    QStringList all;
    for (const CurveSpec& curve : chart.curves)
        all.append(curve.name());
    return all;
}

TEST(DefaultLayout, OfALogHasPoseLegsAndErrorsAsFarAsThereAreColumns) {
    const TemporaryLog log("time_s,l1_mm,l2_mm,x_mm,y_mm,x_path_mm,q\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n");
    const ChartLayout layout = defaultLayout(*log.table());
    ASSERT_EQ(layout.charts.size(), 4U);
    EXPECT_EQ(names(layout.charts[0]), QStringList({QStringLiteral("x_mm"), QStringLiteral("y_mm")}));
    EXPECT_EQ(names(layout.charts[1]), QStringList({QStringLiteral("l1_mm"), QStringLiteral("l2_mm")}));
    EXPECT_EQ(names(layout.charts[2]), QStringList({QStringLiteral("x_mm - x_path_mm")}));
    EXPECT_EQ(names(layout.charts[3]), QStringList({QStringLiteral("q")}));
}

TEST(DefaultLayout, OfAForeignFileShowsItsFirstColumnsOfNumbers) {
    const TemporaryLog log("seconds,a,word,b\n0,1,x,3\n1,2,y,4\n2,3,z,5\n");
    const ChartLayout layout = defaultLayout(*log.table());
    ASSERT_EQ(layout.charts.size(), 1U);
    EXPECT_TRUE(names(layout.charts[0]).contains(QStringLiteral("a")));
    EXPECT_TRUE(names(layout.charts[0]).contains(QStringLiteral("b")));
    EXPECT_FALSE(names(layout.charts[0]).contains(QStringLiteral("word")));
}

TEST(LayoutFile, ComesBackAsItWas) {
    const ChartLayout layout{
        {{QStringLiteral("legs"), {{QStringLiteral("l1_mm"), {}}}},
         {QString(), {{QStringLiteral("x"), QStringLiteral("y")}, {QStringLiteral("z"), {}}}}}};
    EXPECT_EQ(parseLayout(formatLayout(layout), "charts.json"), layout);
}

TEST(LayoutFile, WhatIsNoneIsRefusedWithItsName) {
    for (const char* text : {"", "nothing", "{}", "[1]", R"({"hexapose-layout":1})",
                             R"({"hexapose-layout":1,"charts":[{"curves":[{}]}]})"}) {
        try {
            parseLayout(text, "charts.json");
            ADD_FAILURE() << text;
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()).rfind("charts.json: ", 0), 0U) << error.what();
        }
    }
}

TEST(ChosenCharts, AreChartsByNameAndElseColumns) {
    const TemporaryLog log("time_s,l1_mm,x_mm\n0,1,2\n1,1,2\n");
    const auto table = log.table();
    const ChartLayout chosen = chosenCharts(defaultLayout(*table), *table, {"legs", "x_mm"});
    ASSERT_EQ(chosen.charts.size(), 2U);
    EXPECT_EQ(chosen.charts[0].name, QStringLiteral("legs"));
    EXPECT_EQ(names(chosen.charts[1]), QStringList({QStringLiteral("x_mm")}));
    EXPECT_THROW(chosenCharts(defaultLayout(*table), *table, {"nothing"}), InputError);
}

} // namespace
} // namespace hexapose
