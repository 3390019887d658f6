// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/common/language.h"
#include "ui/console/status/connection_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace hexapose::testing;

class ConnectionPanelTest : public ::testing::Test {
protected:
    ConnectionPanelTest() : panel([this] { return ports; }) {
        panel.setAvailable(true);
        panel.show();
    }
    template <class Widget = QPushButton>
    Widget* find(const char* name) {
        return qobject_cast<Widget*>(findByName(panel, QString::fromLatin1(name)));
    }
    static Snapshot inState(RunState state) {
        return snapshotAt(laboratoryPlatform(), Pose{}, Pose{}, state, 1.0);
    }
    QStringList ports{QStringLiteral("/dev/ttyS0")};
    ConnectionPanel panel;
};

TEST_F(ConnectionPanelTest, OffersTheVirtualPlatformAndThePortsOfTheMoment) {
    auto* box = find<QComboBox>("Connection");
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(panel.choice(), ConnectionSpec(VirtualConnection{}));
    ports << QStringLiteral("/dev/ttyUSB0");
    box->showPopup();
    box->hidePopup();
    EXPECT_EQ(box->count(), 3);
    box->setCurrentIndex(2);
    EXPECT_EQ(panel.choice(), ConnectionSpec(SerialConnection{"/dev/ttyUSB0", 115200}));
    box->setEditText(QStringLiteral("  /dev/pts/7 "));
    EXPECT_EQ(panel.choice(), ConnectionSpec(SerialConnection{"/dev/pts/7", 115200}));
    find<QComboBox>("Baud rate")->setEditText(QStringLiteral("57600"));
    EXPECT_EQ(panel.choice(), ConnectionSpec(SerialConnection{"/dev/pts/7", 57600}));
    for (const char* bad : {"0", "", "-3", "fast"}) {
        find<QComboBox>("Baud rate")->setEditText(QString::fromLatin1(bad));
        EXPECT_FALSE(panel.choice()) << bad;
        EXPECT_FALSE(find("Connect")->isEnabled()) << bad;
    }
}

TEST_F(ConnectionPanelTest, KeysStepThroughTheUsualBaudRates) {
    panel.setChoice(SerialConnection{"/dev/ttyS0", 115200});
    panel.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
    auto* box = find<QComboBox>("Baud rate");
    QTest::mouseClick(box->lineEdit(), Qt::LeftButton);
    // With the focus, and as a program presses them in the field.
    for (QWidget* at : std::initializer_list<QWidget*>{QApplication::focusWidget(), box->lineEdit()}) {
        const auto after = [&](const char* typed, Qt::Key key) {
            box->setEditText(QString::fromLatin1(typed));
            QTest::keyClick(at, key);
            return box->currentText().toStdString();
        };
        EXPECT_EQ(after("115200", Qt::Key_Up), "57600");
        EXPECT_EQ(after("115200", Qt::Key_Down), "230400");
        EXPECT_EQ(after("115200", Qt::Key_PageDown), "230400");
        EXPECT_EQ(after("100000", Qt::Key_Down), "115200") << "from another one to its neighbours";
        EXPECT_EQ(after("100000", Qt::Key_Up), "57600");
        EXPECT_EQ(after("100000", Qt::Key_Up), "57600") << "again";
        EXPECT_EQ(after("2000000", Qt::Key_PageUp), "921600");
        EXPECT_EQ(after("2000000", Qt::Key_Down), "2000000") << "there is no higher one";
        EXPECT_EQ(panel.choice(), ConnectionSpec(SerialConnection{"/dev/ttyS0", 2000000}));
    }
}

TEST_F(ConnectionPanelTest, ButtonsFollowTheState) {
    int disconnects = 0;
    QObject::connect(&panel, &ConnectionPanel::disconnectRequested, [&] { ++disconnects; });
    panel.setOpen(true);
    EXPECT_EQ(find("Connect"), nullptr);
    panel.showSnapshot(inState(RunState::Unreferenced));
    EXPECT_TRUE(find("Reference")->isEnabled());
    EXPECT_FALSE(find("Enable")->isEnabled());
    EXPECT_FALSE(find("Clear")->isEnabled());
    panel.showSnapshot(inState(RunState::Enabled));
    EXPECT_TRUE(find("Disable")->isEnabled());
    panel.showSnapshot(inState(RunState::Stopped));
    EXPECT_TRUE(find("Clear")->isEnabled());
    find("Disconnect")->click();
    EXPECT_EQ(disconnects, 1);
    panel.setOpen(false);
    EXPECT_TRUE(find("Connect")->isEnabled());
    EXPECT_FALSE(find("Reference")->isEnabled());
}

TEST_F(ConnectionPanelTest, TheSolverIsChosenWhileNothingMoves) {
    auto* box = find<QComboBox>("Solver");
    ASSERT_NE(box, nullptr);
    QStringList chosen;
    QObject::connect(&panel, &ConnectionPanel::solverChosen, [&](const QString& word) { chosen << word; });
    panel.setSolver("mpr3-nr");
    EXPECT_EQ(box->currentText(), "MPR3-NR");
    EXPECT_TRUE(chosen.isEmpty()) << "shown, not chosen";
    box->setFocus();
    QTest::keyClick(box, Qt::Key_End);
    EXPECT_EQ(box->currentText(), "FSI");
    EXPECT_EQ(chosen, QStringList{QStringLiteral("fsi")});
    panel.setOpen(true);
    for (const RunState state : {RunState::Moving, RunState::Settling}) {
        panel.showSnapshot(inState(state));
        EXPECT_FALSE(box->isEnabled());
        EXPECT_NE(box->toolTip().indexOf(QStringLiteral("while the platform moves")), -1);
        EXPECT_EQ(box->accessibleDescription(), box->toolTip());
    }
    for (const RunState state : {RunState::Enabled, RunState::Disabled, RunState::Stopped, RunState::Fault}) {
        panel.showSnapshot(inState(state));
        EXPECT_TRUE(box->isEnabled());
        EXPECT_EQ(box->toolTip().indexOf(QStringLiteral("while the platform moves")), -1);
    }
    box->setFocus();
    panel.setSolverPending(true);
    EXPECT_FALSE(box->isEnabled());
    EXPECT_EQ(panel.focusWidget(), nullptr) << "and no button is the next key's";
    EXPECT_NE(box->toolTip().indexOf(QStringLiteral("prepared")), -1);
    panel.setSolverPending(false);
    EXPECT_TRUE(box->isEnabled());
    EXPECT_EQ(panel.focusWidget(), box);
    panel.setSolver("newton-as-published");
    EXPECT_EQ(box->currentIndex(), -1);
    EXPECT_EQ(chosen.size(), 1);
}

TEST_F(ConnectionPanelTest, VirtualPlatformStaysChosenInAnotherLanguage) {
    LanguageSwitch language;
    ASSERT_TRUE(language.choose(QStringLiteral("zh_CN")));
    QCoreApplication::sendPostedEvents();
    EXPECT_EQ(panel.choice(), ConnectionSpec(VirtualConnection{}));
    EXPECT_EQ(find<QComboBox>("Connection"), nullptr);
}

} // namespace
} // namespace hexapose
