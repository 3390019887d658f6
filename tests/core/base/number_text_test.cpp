// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/base/number_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <limits>
#include <random>

using namespace hexapose;

TEST(NumberText, ReadsBackToTheSameDouble) {
    std::mt19937_64 random(5);
    for (int i = 0; i < 20000; ++i) {
        const double value = std::bit_cast<double>(random());
        if (!std::isfinite(value))
            continue;
        EXPECT_EQ(parseNumber(formatNumber(value)), value);
        EXPECT_EQ(parseNumber(formatTomlNumber(value)), value);
    }
    EXPECT_TRUE(std::signbit(*parseNumber(formatTomlNumber(-0.0))));
    EXPECT_EQ(formatNumber(339.5), "339.5");
    EXPECT_EQ(formatTomlNumber(40.0), "40.0");
    EXPECT_EQ(formatNumber(-std::numeric_limits<double>::infinity()), "-inf");
    EXPECT_EQ(formatNumber(-std::nan("")), "nan");
}

TEST(NumberText, FixedDecimalsHaveNoNegativeZero) {
    EXPECT_EQ(formatFixed(-0.04, 1), "0.0");
    EXPECT_EQ(formatFixed(-0.06, 1), "-0.1");
    EXPECT_EQ(formatFixed(-0.4, 0), "0");
    EXPECT_EQ(formatFixed(1234.5678, 2), "1234.57");
    EXPECT_EQ(formatFixed(1e300, 1).size(), 303U);
    EXPECT_EQ(formatFixed(std::nan(""), 1), "nan");
}

TEST(NumberText, ParsesWholeNumbersTextOnly) {
    EXPECT_EQ(parseNumber(" 12.5\t"), 12.5);
    EXPECT_EQ(parseNumber("+1e-3"), 1e-3);
    EXPECT_EQ(parseNumber("-inf"), -std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(*parseNumber("NaN")));
    for (const char* text :
         {"", " ", "1,5", "1.5mm", "0x10", "--1", "+-1", "++1", "1 2", "nan(1)", "1e999", "."})
        EXPECT_FALSE(parseNumber(text).has_value()) << text;
    EXPECT_EQ(parseInteger("-42"), -42);
    EXPECT_EQ(parseInteger("+7 "), 7);
    for (const char* text : {"", "1.0", "9223372036854775808", "seven"})
        EXPECT_FALSE(parseInteger(text).has_value()) << text;
}

TEST(NumberText, IgnoresTheLocale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"})
        if (std::setlocale(LC_ALL, name) != nullptr) {
            EXPECT_EQ(formatFixed(0.5, 2), "0.50");
            EXPECT_EQ(parseNumber("2.5"), 2.5);
        }
    std::setlocale(LC_ALL, before.c_str());
}
