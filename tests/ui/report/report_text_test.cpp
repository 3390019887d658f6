// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace hexapose {
namespace {

ErrorReport reportWithBound(double metres, double radians) {
    ErrorReport report;
    report.rows.resize(1);
    report.rows[0].predictedBound.head<3>().setConstant(metres);
    report.rows[0].predictedBound.tail<3>().setConstant(radians);
    return report;
}

TEST(ReportNumbers, ShowWhatTheResolutionLetsBeSeen) {
    EXPECT_EQ(errorText(-1.686e-4), "-1.69e-4");
    EXPECT_EQ(errorText(0.0), "0");
    EXPECT_EQ(errorText(12345.0), "1.23e4");
    EXPECT_EQ(errorText(std::nan("")), QStringLiteral("–"));
    EXPECT_EQ(errorText(std::numeric_limits<double>::infinity()), QStringLiteral("∞"));

    const PoseDecimals laboratory(reportWithBound(2e-4, 1e-3));
    EXPECT_EQ(laboratory.si(0, 0.01199), "0.011990");
    EXPECT_EQ(laboratory.common(0, 0.01199), "11.990");
    EXPECT_EQ(laboratory.si(5, 0.08689), "0.08689");
    EXPECT_EQ(laboratory.common(5, 0.08689), "4.9784");
    EXPECT_EQ(laboratory.commonError(2, -2.2e-4), "-0.2200");
    EXPECT_EQ(laboratory.commonError(2, 1e-9), "1.00e-6")
        << "an error too small to be seen is not shown as none";
    EXPECT_EQ(laboratory.common(1, std::nan("")), QStringLiteral("–"));

    const PoseDecimals tiny(reportWithBound(2e-9, 1e-6));
    const PoseDecimals singular(reportWithBound(std::numeric_limits<double>::infinity(), 0.0));
    for (const double value : {1.0, -123.456789, 1.23456789e-5, -9.87654321e9, 0.0})
        for (const PoseDecimals* decimals : {&laboratory, &tiny, &singular})
            for (int k = 0; k < 6; ++k)
                for (const QString& text :
                     {decimals->si(k, value), decimals->common(k, value), decimals->commonError(k, value)})
                    EXPECT_LE(text.size(), 11) << text.toStdString() << " does not fit into its column";
}

} // namespace
} // namespace hexapose
