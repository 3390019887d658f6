// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/table/cell_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace hexapose {
namespace {

TEST(CellText, NumbersAreUnderstoodWholeOrRefused) {
    EXPECT_EQ(parseCell("1.5", '.'), 1.5);
    EXPECT_EQ(parseCell(" +1.5\t", '.'), 1.5);
    EXPECT_EQ(parseCell("1,5", ','), 1.5);
    EXPECT_EQ(parseCell("1.5", ','), 1.5) << "a point is understood as well";
    for (const char* text :
         {"", "-", "1.5x", "1 5", "1,5", "+-1", "--1", "nan", "inf", "-inf", "0x1", "1e999", "."})
        EXPECT_FALSE(parseCell(text, '.')) << text;
    for (const char* text : {"1.234,5", "1,2,3"})
        EXPECT_FALSE(parseCell(text, ',')) << text;
}

TEST(CellText, DecimalTimesAreExact) {
    EXPECT_EQ(parseDecimalTime("0.001", '.', 1'000'000'000), 1'000'000);
    EXPECT_EQ(parseDecimalTime("-1.5", '.', 1'000'000'000), -1'500'000'000);
    EXPECT_EQ(parseDecimalTime("1,5", ',', 1'000), 1'500);
    EXPECT_EQ(parseDecimalTime("9223372036.854775807", '.', 1'000'000'000),
              std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(parseDecimalTime("0.1234567894999", '.', 1'000'000'000), 123456789);
    EXPECT_EQ(parseDecimalTime("0.1234567895", '.', 1'000'000'000), 123456790);
    EXPECT_EQ(parseDecimalTime("1e3", '.', 1'000'000'000), 1'000'000'000'000);
    EXPECT_EQ(parseDecimalTime("1795953600123456789", '.', 1), 1795953600123456789);
    for (const char* text : {"", "x", "-", ".", "1.5.2", "99999999999999999999", "1e30", "9223372037"})
        EXPECT_FALSE(parseDecimalTime(text, '.', 1'000'000'000)) << text;
}

TEST(CellText, IsoTimesWithAndWithoutZone) {
    constexpr std::int64_t kNoon = 1795953600'000'000'000;
    for (const char* text :
         {"2026-11-29T12:00:00Z", "2026-11-29 12:00:00", "2026-11-29T12:00", "2026-11-29T13:00:00+01:00",
          "2026-11-29T13:00:00+0100", "2026-11-29T13:00+01", "2026-11-29T06:30:00-05:30",
          "2026-11-29t12:00:00.000z", "2026-11-29  12:00:00.0 Z"})
        EXPECT_EQ(parseIsoTime(text), kNoon) << text;
    EXPECT_EQ(parseIsoTime("2026-11-29"), kNoon - 43200'000'000'000);
    EXPECT_EQ(parseIsoTime("2026-11-29T12:00:00,5Z"), kNoon + 500'000'000);
    EXPECT_EQ(parseIsoTime("1969-12-31T23:59:59.5Z"), -500'000'000);
    for (const char* text :
         {"", "2026", "2026-13-01T00:00:00Z", "2026-02-30T00:00:00Z", "2026-11-29T24:00:00Z",
          "2026-11-29T12:60:00Z", "2026-11-29T12:00:00X", "2026-11-29T12:00:00+1", "12:00:00",
          "2026-11-29T12:00:00Zz", "9999-11-29T12:00:00Z"})
        EXPECT_FALSE(parseIsoTime(text)) << text;
}

} // namespace
} // namespace hexapose
