// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/viewer/temporary_log.h"
#include "ui/viewer/row_text.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using testing::TemporaryLog;

std::string rows(const TemporaryLog& log, double from, double to) {
    std::string text;
    copyRows(log.file(), *log.table(), {from, to}, [&](std::string_view part) { text += part; });
    return text;
}

TEST(CopyRows, AreTheLogsOwnText) {
    const TemporaryLog log("time_s,a,b\n0,1.50,\"x, y\"\n1,2.50,\"two\nlines\"\n2,3.50,z\n3,4.50,z\n");
    EXPECT_EQ(rows(log, 0.0, 3.0), testing::bytesOf(log.file()));
    EXPECT_EQ(rows(log, 1.0, 2.0), "time_s,a,b\n1,2.50,\"two\nlines\"\n2,3.50,z\n");
    EXPECT_EQ(rows(log, 2.5, 9.0), "time_s,a,b\n3,4.50,z\n");
    EXPECT_EQ(rows(log, 7.0, 9.0), "time_s,a,b\n");
}

TEST(CopyRows, KeepLineEndsAndAddTheLastOne) {
    const TemporaryLog windows("time_s,a\r\n0,1\r\n1,2\r\n2,3\r\n");
    EXPECT_EQ(rows(windows, 1.0, 1.0), "time_s,a\n1,2\r\n");
    const TemporaryLog open("time_s,a\n0,1\n1,2");
    EXPECT_EQ(rows(open, 1.0, 1.0), "time_s,a\n1,2\n");
}

TEST(CopyRows, OfManyRowsBeginAndEndWhereTheyShall) {
    const TemporaryLog log(testing::logText(20000));
    const std::string all = testing::bytesOf(log.file());
    const std::string part = rows(log, 100.0, 150.0);
    const std::size_t begin = all.find("\n100.000000,") + 1;
    const std::size_t end = all.find("\n150.010000,") + 1;
    EXPECT_EQ(part, "time_s,a,state,event\n" + all.substr(begin, end - begin));
}

TEST(TextOfLine, IsTheLineAsItStands) {
    const TemporaryLog log("time_s,a\n0,1\n1,x y\n2,3,4\n3,5\n");
    const auto table = log.table();
    EXPECT_EQ(textOfLine(log.file(), *table, 1), "time_s,a");
    EXPECT_EQ(textOfLine(log.file(), *table, 3), "1,x y");
    EXPECT_EQ(textOfLine(log.file(), *table, 4), "2,3,4");
    EXPECT_EQ(textOfLine(log.file(), *table, 5), "3,5");
}

TEST(TextOfLine, IsCutWhereItIsLong) {
    const TemporaryLog log("time_s,a\n0," + std::string(100000, 'x') + "\n1,2\n");
    EXPECT_LT(textOfLine(log.file(), *log.table(), 2).size(), 1000U);
}

} // namespace
} // namespace hexapose
