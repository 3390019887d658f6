// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/viewer/temporary_log.h"
#include "ui/viewer/table_marks.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using testing::logText;
using testing::TemporaryLog;

class TableMarksTest : public ::testing::Test {
protected:
    TableMarksTest() : log(logText(4000)), table(log.table()) { marks.follow(*table); }
    auto spans(double from, double to) {
        return marks.spans(*table, {from, to}, 500, themeColors(ThemeKind::Light));
    }
    TemporaryLog log;
    std::shared_ptr<const Table> table;
    TableMarks marks;
};

TEST_F(TableMarksTest, StatesAreSpansWithTheirWords) {
    const auto all = spans(0.0, 40.0);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[1].label, QStringLiteral("moving"));
    EXPECT_DOUBLE_EQ(all[1].begin, 10.0);
    EXPECT_DOUBLE_EQ(all[1].end, 20.0);
    EXPECT_NE(all[0].colour, all[1].colour);
}

TEST_F(TableMarksTest, AViewWithinAStateHasItWhole) {
    const auto all = spans(12.0, 13.0);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].label, QStringLiteral("moving"));
}

TEST_F(TableMarksTest, EventsAreInstantsWithTheirText) {
    const auto all = marks.instants(*table, {0.0, 40.0}, 500);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_DOUBLE_EQ(all[0].x, 10.0);
    EXPECT_EQ(all[0].label, QStringLiteral("motion started"));
    EXPECT_EQ(marks.instants(*table, {15.0, 40.0}, 500).size(), 1U);
    EXPECT_TRUE(marks.instants(*table, {25.0, 40.0}, 500).empty());
}

TEST_F(TableMarksTest, NoMoreEventsThanPixels) {
    std::string text = "time_s,event\n";
    for (int i = 0; i < 10000; ++i)
        text += std::to_string(i) + ",e" + std::to_string(i % 5) + "\n";
    const TemporaryLog crowded(text);
    const auto many = crowded.table();
    TableMarks ofMany;
    ofMany.follow(*many);
    EXPECT_LE(ofMany.instants(*many, {0.0, 10000.0}, 300).size(), 301U);
}

} // namespace
} // namespace hexapose
