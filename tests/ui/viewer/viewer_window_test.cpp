// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/screen_reader.h"
#include "tests/ui/viewer/temporary_log.h"
#include "ui/common/language.h"
#include "ui/viewer/viewer_window.h"

#include <QFileInfo>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using testing::findByName;
using testing::logText;
using testing::spokenText;
using testing::TemporaryLog;
using testing::waitUntil;

class ViewerWindowTest : public ::testing::Test {
protected:
    ViewerWindowTest() {
        applyTheme(*qApp, ThemeKind::Light);
        window.show();
    }
    void open(const TemporaryLog& log) {
        window.openLogs({log.path()});
        ASSERT_TRUE(waitUntil([this] { return window.current()->file().progress().isDone; }));
        ASSERT_TRUE(waitUntil([&] {
            return window.current()->sheet().table()->rowCount() == window.current()->file().progress().rows;
        }));
    }
    QString text(const char* name) { return spokenText(window, QString::fromLatin1(name)); }
    template <typename Widget>
    Widget& get(const char* name) {
        auto* widget = dynamic_cast<Widget*>(findByName(window, QString::fromLatin1(name)));
        EXPECT_NE(widget, nullptr) << name;
        return *widget;
    }
    ViewerWindow window;
};

TEST_F(ViewerWindowTest, SaysHowMuchThereIs) {
    EXPECT_EQ(text("Rows"), QStringLiteral("--"));
    const TemporaryLog log(logText(4000));
    open(log);
    EXPECT_EQ(text("Rows"), QStringLiteral("4000"));
    EXPECT_EQ(text("Columns"), QStringLiteral("4"));
    EXPECT_EQ(text("Time span"), QStringLiteral("39.990 s"));
    EXPECT_EQ(get<QListWidget>("Column list").count(), 4);
    EXPECT_EQ(get<QListView>("Problems").model()->rowCount(), 0);
    EXPECT_TRUE(window.windowTitle().startsWith(QStringLiteral("run.csv")));
}

TEST_F(ViewerWindowTest, ListsProblemsAndShowsTheLineOfOne) {
    const TemporaryLog log("time_s,a,b\n0,1,2\n1,oops,3\n2,3\n3,4,5\n");
    open(log);
    auto& list = get<QListView>("Problems");
    ASSERT_EQ(list.model()->rowCount(), 2);
    const QString first = list.model()->index(0, 0).data().toString();
    EXPECT_TRUE(first.contains(QStringLiteral("line 3, a"))) << first.toStdString();
    list.setCurrentIndex(list.model()->index(0, 0));
    EXPECT_EQ(text("Text of the line"), QStringLiteral("1,oops,3"));
    list.setCurrentIndex(list.model()->index(1, 0));
    EXPECT_EQ(text("Text of the line"), QStringLiteral("2,3"));
}

TEST_F(ViewerWindowTest, WhatCannotBeReadIsSaid) {
    const TemporaryLog log("");
    open(log);
    EXPECT_TRUE(waitUntil([this] { return text("Reading").contains(QStringLiteral("empty")); }))
        << text("Reading").toStdString();
}

TEST_F(ViewerWindowTest, CursorsGiveValuesAndStatistics) {
    const TemporaryLog log("time_s,a\n0,1\n1,2\n2,4\n3,8\n4,16\n");
    open(log);
    get<QLineEdit>("Cursor A").setText(QStringLiteral("1"));
    get<QLineEdit>("Cursor B").setText(QStringLiteral("3.5"));
    EXPECT_EQ(text("A a"), QStringLiteral("2"));
    EXPECT_EQ(text("B a"), QStringLiteral("8")); // the one before
    EXPECT_EQ(text("Difference a"), QStringLiteral("6"));
    ASSERT_TRUE(waitUntil([this] { return text("Count a") == QStringLiteral("3"); }));
    EXPECT_EQ(text("Minimum a"), QStringLiteral("2"));
    EXPECT_EQ(text("Maximum a"), QStringLiteral("8"));
    EXPECT_EQ(text("Mean a").left(6), QStringLiteral("4.6666"));
    EXPECT_EQ(text("Sigma a").left(6), QStringLiteral("3.0550"));
    EXPECT_EQ(text("RMS a").left(6), QStringLiteral("5.2915"));
    get<QLineEdit>("Cursor B").setText(QString());
    EXPECT_EQ(text("B a"), QStringLiteral("--"));
    ASSERT_TRUE(waitUntil([this] { return text("Count a") == QStringLiteral("5"); })); // of the view
}

TEST_F(ViewerWindowTest, AWrongTimeChangesNoCursor) {
    const TemporaryLog log(logText(100));
    open(log);
    get<QLineEdit>("Cursor A").setText(QStringLiteral("0.5"));
    get<QLineEdit>("Cursor A").setText(QStringLiteral("0.5x"));
    EXPECT_EQ(window.current()->sheet().cursors().a, 0.5);
    EXPECT_FALSE(get<QLineEdit>("Cursor A").accessibleDescription().isEmpty());
    EXPECT_EQ(get<QLineEdit>("Cursor A").text(), QStringLiteral("0.5x"));
}

TEST_F(ViewerWindowTest, ColumnsGoIntoChartsByKeysAndButtons) {
    const TemporaryLog log("time_s,a,b\n0,1,2\n1,2,3\n2,3,4\n");
    open(log);
    auto& list = get<QListWidget>("Column list");
    list.setCurrentRow(1);
    QTest::mouseClick(&get<QPushButton>("New chart"), Qt::LeftButton);
    EXPECT_EQ(window.current()->sheet().chartCount(), 2U);
    list.setCurrentRow(2);
    QTest::keyClick(&list, Qt::Key_Return);
    EXPECT_EQ(window.current()->sheet().chartLayout().charts[1].curves.size(), 2U);
    get<QLineEdit>("Filter columns").setText(QStringLiteral("b"));
    EXPECT_TRUE(list.item(1)->isHidden());
}

TEST_F(ViewerWindowTest, ExportsThePageOrOneChartOfIt) {
    const TemporaryLog log("time_s,l1_mm,q\n0,1,2\n1,2,3\n2,3,4\n");
    open(log);
    const QString all = log.folder() + QStringLiteral("/all.svg"),
                  one = log.folder() + QStringLiteral("/one.svg");
    const auto isThere = [](const QString& file) { return [file] { return QFileInfo::exists(file); }; };
    window.exportTo(all);
    ASSERT_TRUE(waitUntil(isThere(all)));
    ASSERT_TRUE(waitUntil([this] { return get<QPushButton>("Export").isEnabled(); }));
    window.exportTo(one, window.current()->sheet().chartLayout().charts.at(0));
    ASSERT_TRUE(waitUntil(isThere(one)));
    EXPECT_LT(QFileInfo(one).size(), QFileInfo(all).size());
}

TEST_F(ViewerWindowTest, LogsLieBehindTabs) {
    const TemporaryLog one(logText(100), "one.csv"), two(logText(200), "two.csv");
    open(one);
    open(two);
    EXPECT_EQ(window.logCount(), 2);
    EXPECT_EQ(text("Rows"), QStringLiteral("200"));
    window.closeLog(1);
    EXPECT_EQ(text("Rows"), QStringLiteral("100"));
    window.closeLog(0);
    EXPECT_EQ(text("Rows"), QStringLiteral("--"));
    EXPECT_EQ(window.current(), nullptr);
}

TEST_F(ViewerWindowTest, ADroppedFileIsOpened) {
    const TemporaryLog log(logText(100));
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(log.path())});
    testing::drop(window, data);
    EXPECT_EQ(window.logCount(), 1);
}

TEST_F(ViewerWindowTest, SpeaksChineseAtOnce) {
    LanguageSwitch language;
    ASSERT_TRUE(language.choose(QStringLiteral("zh_CN")));
    QApplication::processEvents();
    EXPECT_NE(findByName(window, QString::fromUtf8("打开日志")), nullptr);
    language.choose(QStringLiteral("en"));
    QApplication::processEvents();
    EXPECT_NE(findByName(window, QStringLiteral("Open log")), nullptr);
}

TEST_F(ViewerWindowTest, EveryControlHasANameAndTheWindowFits) {
    const TemporaryLog log(logText(100));
    open(log);
    for (const QWidget* control : window.findChildren<QPushButton*>())
        EXPECT_FALSE(control->accessibleName().isEmpty());
    EXPECT_LE(window.minimumSizeHint().width(), 900);
    EXPECT_LE(window.minimumSizeHint().height(), 600);
}

} // namespace
} // namespace hexapose
