// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/nice_ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hexapose {
namespace {

TEST(NiceTicks, AreRoundFewAndTruthful) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        const double span = std::pow(10.0, 40.0 * uniform(random) - 20.0);
        const double low = (uniform(random) - 0.7) * span;
        const int most = 2 + i % 12;
        const Ticks ticks = niceTicks(low, low + span, most);
        ASSERT_EQ(ticks.labels.size(), ticks.values.size());
        EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(most) + 1);
        EXPECT_GE(ticks.values.size(), static_cast<std::size_t>(most) / 3);
        for (std::size_t k = 0; k < ticks.values.size(); ++k) {
            EXPECT_GE(ticks.values[k], low - 1e-6 * span);
            EXPECT_LE(ticks.values[k], low + (1 + 1e-6) * span);
            bool read = false;
            const double shown = ticks.labels[k].toDouble(&read) * std::pow(10.0, ticks.exponent);
            EXPECT_TRUE(read);
            EXPECT_NEAR(shown, ticks.values[k], 1e-9 * span)
                << "the label tells the value, no digit is cut off";
            EXPECT_LE(ticks.labels[k].size(), 8);
        }
    }
}

TEST(NiceTicks, HaveTheirPowerOfTenTakenOut) {
    const Ticks small = niceTicks(-2.2e-4, 2.2e-4, 5);
    EXPECT_EQ(small.exponent, -4);
    EXPECT_EQ(small.labels, (std::vector<QString>{"-2", "-1", "0", "1", "2"}));
    const Ticks plain = niceTicks(-0.6, 0.6, 5);
    EXPECT_EQ(plain.exponent, 0);
    EXPECT_EQ(plain.labels, (std::vector<QString>{"-0.5", "0.0", "0.5"}));
    EXPECT_EQ(niceTicks(0.5, 3.5, 20, TickLabels::Whole).labels, (std::vector<QString>{"1", "2", "3"}));
    EXPECT_EQ(niceTicks(0.5, 20000.5, 3, TickLabels::Whole).labels.back(), "20000");
    EXPECT_EQ(timesPowerOfTen(-12), QStringLiteral("×10⁻¹²"));
    EXPECT_EQ(timesPowerOfTen(0), QString());
}

TEST(NiceTicks, KeepToTheSettledDistanceWhileThereIsRoom) {
    const AxisRange range{-40.0, 40.0, 20.0};
    EXPECT_EQ(niceTicks(range, 8).labels, (std::vector<QString>{"-40", "-20", "0", "20", "40"}));
    EXPECT_EQ(niceTicks(range, 2).labels, (std::vector<QString>{"-40", "0", "40"})) << "every second";
    EXPECT_EQ(niceTicks(AxisRange{0.0, 5.0, 0.5}, 2).labels, (std::vector<QString>{"0.0", "2.5", "5.0"}));
    EXPECT_EQ(niceTicks(AxisRange{-0.2, 0.2, 0.2}, 8).labels, (std::vector<QString>{"-0.2", "0.0", "0.2"}));
    EXPECT_EQ(niceTicks(AxisRange{0.0, 0.1, 0.05}, 8).labels, (std::vector<QString>{"0.00", "0.05", "0.10"}));
    EXPECT_EQ(niceTicks(AxisRange{36000.0, 36001.0, 0.5}, 8, TickLabels::Plain).labels,
              (std::vector<QString>{"36000.0", "36000.5", "36001.0"}))
        << "hours into a session";
}

TEST(GrownRange, StaysAsInTheFigureAndGrowsToRoundNumbers) {
    EXPECT_EQ(grownRange(-40.0, 40.0, std::nullopt), (AxisRange{-40.0, 40.0, 20.0}));
    EXPECT_EQ(grownRange(-40.0, 40.0, std::pair(-39.0, 40.0)), (AxisRange{-40.0, 40.0, 20.0}));
    EXPECT_EQ(grownRange(-40.0, 40.0, std::pair(-12.0, 57.0)), (AxisRange{-50.0, 100.0, 50.0}));
    EXPECT_EQ(grownRange(-10.0, 10.0, std::pair(-11.0, 0.0)), (AxisRange{-20.0, 10.0, 10.0}));
    EXPECT_EQ(niceStep(0.3), 0.5);
    EXPECT_EQ(niceStep(20.0), 20.0);
    EXPECT_EQ(niceStep(51.0), 100.0);
}

} // namespace
} // namespace hexapose
