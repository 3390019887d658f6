// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/input_error.h"
#include "tests/ui/viewer/temporary_log.h"
#include "ui/viewer/chart_export.h"

#include <QImage>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using testing::bytesOf;
using testing::TemporaryLog;

class ChartExportTest : public ::testing::Test {
protected:
    ChartExportTest() : log(testing::logText(3000)), table(log.table()) {}
    ChartPicture picture() const { return {table, defaultLayout(*table), {5.0, 25.0}, log.file()}; }
    std::string target(const char* name) const {
        return (log.folder() + QLatin1Char('/') + QString::fromLatin1(name)).toStdString();
    }

    TemporaryLog log;
    std::shared_ptr<const Table> table;
};

TEST_F(ChartExportTest, WritesEachKindByItsEnding) {
    exportCharts(picture(), target("a.png"));
    EXPECT_FALSE(QImage(QString::fromStdString(target("a.png"))).isNull());
    exportCharts(picture(), target("a.svg"));
    EXPECT_NE(bytesOf(target("a.svg")).find("<svg"), std::string::npos);
    exportCharts(picture(), target("a.PDF"));
    EXPECT_EQ(bytesOf(target("a.PDF")).substr(0, 5), "%PDF-");
    exportCharts(picture(), target("a.csv"));
    EXPECT_EQ(bytesOf(target("a.csv")).substr(0, 9), "time_s,a,");
}

TEST_F(ChartExportTest, RefusesWhatItCannotWrite) {
    EXPECT_THROW(exportCharts(picture(), target("a.txt")), InputError);
    EXPECT_THROW(exportCharts(picture(), target("no/such/folder.png")), InputError);
}

TEST_F(ChartExportTest, NeverWritesOverItsOwnLog) {
    const std::string before = bytesOf(log.file());
    EXPECT_THROW(exportCharts(picture(), log.file()), InputError);
    EXPECT_EQ(bytesOf(log.file()), before);
}

} // namespace
} // namespace hexapose
