// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/viewer/temporary_log.h"
#include "ui/viewer/curve_finder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hexapose {
namespace {

using testing::TemporaryLog;

CurveSpec difference(const char* column, const char* minus) {
    return {QString::fromLatin1(column), QString::fromLatin1(minus)};
}

TEST(CurveFinder, ADifferenceIsWorkedOutRowByRow) {
    const TemporaryLog log("time_s,x_mm,x_path_mm\n0,5,3\n1,,3\n2,7,8\n");
    CurveFinder finder;
    finder.follow(log.table());
    const auto curve = finder.find(difference("x_mm", "x_path_mm"));
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->column->number(0), 2.0);
    EXPECT_TRUE(std::isnan(curve->column->number(1)));
    EXPECT_EQ(curve->column->number(2), -1.0);
    EXPECT_EQ(curve->column->range(0, 3), (MinMax{-1.0, 2.0}));
    EXPECT_EQ(curve->column->info().unit, "mm");
}

TEST(CurveFinder, AnglesBeyondHalfATurnAreNear) {
    const TemporaryLog log("time_s,gamma_deg,gamma_path_deg\n0,179,-179\n1,1,2\n");
    CurveFinder finder;
    finder.follow(log.table());
    const auto curve = finder.find(difference("gamma_deg", "gamma_path_deg"));
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->column->number(0), -2.0);
}

TEST(CurveFinder, WhatTheLogLacksOrIsNoNumberIsNotFound) {
    const TemporaryLog log("time_s,x_mm,state\n0,5,moving\n1,5,moving\n");
    CurveFinder finder;
    finder.follow(log.table());
    EXPECT_FALSE(finder.find(difference("y_mm", "")));
    EXPECT_FALSE(finder.find(difference("state", "")));
    EXPECT_FALSE(finder.find(difference("x_mm", "y_mm")));
    EXPECT_TRUE(finder.find(difference("x_mm", "")));
}

} // namespace
} // namespace hexapose
