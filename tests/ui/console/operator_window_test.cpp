// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/common/language.h"
#include "ui/common/number_field.h"
#include "ui/console/events/event_list.h"
#include "ui/console/motion/jog_panel.h"
#include "ui/console/motion/motion_panel.h"
#include "ui/console/motion/target_panel.h"
#include "ui/console/motion/way_point_table.h"
#include "ui/console/motion/way_points_panel.h"
#include "ui/console/report/report_panel.h"
#include "ui/console/window/operator_window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSlider>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <functional>

namespace hexapose {
namespace {

using namespace hexapose::testing;

class OperatorWindowTest : public ::testing::Test {
protected:
    OperatorWindowTest()
        : geometry(laboratoryPlatform()), window(makeModel(geometry), [] { return QStringList(); }) {
        SessionSetup setup;
        setup.model = makeModel(geometry);
        setup.solver = newtonSolver(geometry);
        setup.logDirectory = folder.path().toStdString();
        window.setSession(std::make_unique<Session>(
            setup, [this](const ConnectionSpec&) { return std::make_unique<InstantDevice>(geometry); }));
        window.show();
    }
    QPushButton* button(const char* name) {
        return qobject_cast<QPushButton*>(findByName(window, QString::fromLatin1(name)));
    }
    QString spoken(const char* name) { return spokenText(window, QString::fromLatin1(name)); }
    bool waitFor(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatienceMs); }
    void type(const char* field, const char* text) {
        auto* found = qobject_cast<NumberField*>(findByName(window, QString::fromLatin1(field)));
        ASSERT_NE(found, nullptr) << field;
        found->selectAll();
        QTest::keyClicks(found, QString::fromLatin1(text));
    }
    /// Every name that a screen reader meets, captions among them.
    QStringList spokenNames() {
        QStringList names;
        for (QWidget* widget : window.findChildren<QWidget*>()) {
            if (QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(widget)) {
                names << accessible->text(QAccessible::Name);
            }
        }
        return names;
    }
    bool happened(const char* text) {
        for (int i = 0; i < window.events().count(); ++i) {
            if (window.events().textAt(i).contains(QString::fromLatin1(text))) {
                return true;
            }
        }
        return false;
    }

    QTemporaryDir folder;
    PlatformGeometry geometry;
    OperatorWindow window;
};

TEST_F(OperatorWindowTest, OperatorsMainJob) {
    EXPECT_FALSE(button("Run")->isEnabled());
    button("Connect")->click();
    ASSERT_TRUE(waitFor([this] { return button("Run")->isEnabled() && spoken("Measured x") == "0.000"; }));
    type("Target x", "2");
    type("Target gamma", "1.5");
    ASSERT_TRUE(waitFor([this] { return button("Run")->isEnabled(); }));
    EXPECT_EQ(spoken("Validity"), "Reachable");
    button("Run")->click();
    ASSERT_TRUE(waitFor([this] { return happened("Settled after"); }));
    constexpr double kMm = 0.001;
    EXPECT_NEAR(spoken("Measured x").toDouble(), 2.0, kMm);
    EXPECT_NEAR(spoken("Measured gamma").toDouble(), 1.5, kMm);
    EXPECT_EQ(spoken("State"), "Enabled");
    EXPECT_FALSE(window.session()->logFile().empty());

    // Closing while enabled asks, and nothing modal is in the way of Stop.
    window.close();
    EXPECT_TRUE(window.isVisible());
    auto* question = window.findChild<QMessageBox*>();
    ASSERT_NE(question, nullptr);
    EXPECT_FALSE(question->isModal());
    button("Stop")->click();
    ASSERT_TRUE(waitFor([this] { return spoken("State") == "Stopped"; }));
    ASSERT_TRUE(waitFor([this] { return spoken("Validity").contains(QStringLiteral("Clear")); }));
    EXPECT_FALSE(button("Run")->isEnabled());
    button("Clear")->click();
    ASSERT_TRUE(waitFor([this] { return spoken("State") == "Disabled"; }));
    button("Disconnect")->click();
    EXPECT_EQ(spoken("State"), "Disconnected");
    EXPECT_EQ(spoken("Measured x"), "--");
    EXPECT_FALSE(button("Run")->isEnabled());
    window.close();
    EXPECT_FALSE(window.isVisible());
}

TEST_F(OperatorWindowTest, EveryControlHasANameInEveryLanguage) {
    const auto check = [this] {
        for (QWidget* widget : window.findChildren<QWidget*>()) {
            const bool control = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
                                 qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QLineEdit*>(widget);
            const bool part = widget->objectName().startsWith(QLatin1String("qt_")) ||
                              qobject_cast<QComboBox*>(widget->parentWidget()) != nullptr ||
                              qobject_cast<QTableView*>(widget->parentWidget()) != nullptr;
            if (control && !part) {
                EXPECT_FALSE(widget->accessibleName().isEmpty())
                    << widget->metaObject()->className() << " in "
                    << widget->parentWidget()->metaObject()->className();
            }
        }
    };
    check();
    const QStringList names{"Target x",
                            "Target gamma",
                            "Run",
                            "Stop",
                            "Reset",
                            "Connect",
                            "Leg 1 measured",
                            "Leg 6 set-point",
                            "Leg 3 error",
                            "Measured x",
                            "Measured gamma",
                            "Error alpha",
                            "State",
                            "Validity",
                            "Rate",
                            "Age",
                            "Solver",
                            "Iterations",
                            "Residual",
                            "Dropped frames",
                            "Export report",
                            "Run report",
                            "Pose",
                            "Legs",
                            "Errors",
                            "Connection",
                            "Baud rate",
                            "Events",
                            "Platform",
                            "Mode",
                            "Speed",
                            "Jog +x",
                            "Jog -gamma",
                            "Jog frame",
                            "Jog step",
                            "Way-points",
                            "Add measured",
                            "Add target",
                            "Play",
                            "Pause motion",
                            "Step",
                            "Guided test",
                            "Test measured x",
                            "Test length 6",
                            "Settled",
                            "Singularity margin q"};
    for (const QString& name : names) {
        EXPECT_EQ(spokenNames().count(name), 1) << name.toStdString();
    }
    LanguageSwitch language;
    ASSERT_TRUE(language.choose(QStringLiteral("zh_CN")));
    QCoreApplication::sendPostedEvents();
    check();
    EXPECT_EQ(findByName(window, QStringLiteral("Run")), nullptr);
    EXPECT_NE(spoken("Solver"), "Newton"); // found by no English name any more
}

TEST_F(OperatorWindowTest, EscStopsAtTheFirstPressWhileAPopupIsOpen) {
    int stops = 0;
    QObject::connect(&window.motionPanel(), &MotionPanel::stopRequested, &window, [&stops] { ++stops; });
    auto* box = qobject_cast<QComboBox*>(findByName(window, QStringLiteral("Connection"))->parentWidget());
    if (box == nullptr) {
        box = qobject_cast<QComboBox*>(findByName(window, QStringLiteral("Connection")));
    }
    ASSERT_NE(box, nullptr);
    box->showPopup();
    ASSERT_NE(QApplication::activePopupWidget(), nullptr);
    QTest::keyClick(QApplication::activePopupWidget()->windowHandle(), Qt::Key_Escape);
    EXPECT_GE(stops, 1);
    EXPECT_FALSE(box->view()->isVisible()) << "it closes as it always did";

    stops = 0;
    QMenu* menu = window.menuBar()->addMenu(QStringLiteral("Anything"));
    menu->addAction(QStringLiteral("some"));
    menu->popup(window.mapToGlobal(QPoint(5, 5)));
    ASSERT_EQ(QApplication::activePopupWidget(), menu);
    QTest::keyClick(menu->windowHandle(), Qt::Key_Escape);
    EXPECT_GE(stops, 1);
    EXPECT_FALSE(menu->isVisible());
}

/// Also the dialogs of the report page, which have a folder or a list chosen while something moves.
TEST_F(OperatorWindowTest, FileDialogsLeaveStopAndEscWithinReach) {
    int stops = 0;
    QObject::connect(&window.motionPanel(), &MotionPanel::stopRequested, &window, [&stops] { ++stops; });
    window.motionPanel().wayPoints().table().setPoses({Pose{}}); // something to save
    for (const char* name : {"From CSV...", "Choose report folder", "Load way-points", "Save way-points"}) {
        SCOPED_TRACE(name);
        button(name)->click();
        button(name)->click(); // it is open already
        const auto dialogs = window.findChildren<QFileDialog*>();
        ASSERT_EQ(dialogs.size(), 1);
        const QPointer<QFileDialog> dialog = dialogs.first();
        EXPECT_TRUE(dialog->isVisible());
        EXPECT_FALSE(dialog->isModal());
        EXPECT_TRUE(dialog->testOption(QFileDialog::DontUseNativeDialog)) << "it would keep Esc for itself";
        stops = 0;
        button("Stop")->click();
        EXPECT_EQ(stops, 1);
        QTest::keyClick(dialog->windowHandle(), Qt::Key_Escape);
        EXPECT_GE(stops, 2);
        delete dialog.data(); // which Esc may have closed already
    }
}

TEST_F(OperatorWindowTest, SilentLoopIsShownAsOldData) {
    window.showSnapshots({std::make_shared<Snapshot>(
        snapshotAt(geometry, poseOf(1, 0, 0, 0, 0, 0), Pose{}, RunState::Enabled, 1.0))});
    EXPECT_FALSE(window.latest().stale);
    ASSERT_TRUE(waitFor([this] {
        window.showSnapshots({});
        return window.latest().stale;
    }));
    EXPECT_GT(spoken("Age").toDouble(), 400.0);
}

TEST_F(OperatorWindowTest, FitsASmallScreenAndEveryPageKeepsStop) {
    EXPECT_LE(window.minimumSizeHint().width(), 1280);
    EXPECT_LE(window.minimumSizeHint().height(), 770);
    for (const char* page : {"Console", "Report"}) {
        button(page)->click();
        EXPECT_TRUE(button("Stop")->isVisible()) << page;
        EXPECT_TRUE(button("Export report")->isVisible()) << page;
        for (const auto motion :
             {MotionPanel::Target, MotionPanel::Jog, MotionPanel::WayPoints, MotionPanel::Test}) {
            window.motionPanel().showPage(motion);
            EXPECT_TRUE(button("Stop")->isVisible()) << page << motion;
        }
    }
}

TEST_F(OperatorWindowTest, ASpeedChosenBeforehandHoldsForTheNewSession) {
    auto* slider = qobject_cast<QSlider*>(findByName(window, QStringLiteral("Speed")));
    ASSERT_NE(slider, nullptr);
    slider->setValue(40);
    EXPECT_EQ(spoken("Speed in force"), "40 %");
    for (int session = 0; session < 2; ++session) {
        button("Connect")->click();
        ASSERT_TRUE(waitFor([this] { return window.latest().speed == 0.4; })) << session;
        button("Disconnect")->click();
        EXPECT_EQ(window.latest().speed, 1.0) << "nobody is there";
    }
}

TEST_F(OperatorWindowTest, AHeldJogButtonMovesThePlatformAndLettingGoEndsIt) {
    button("Connect")->click();
    ASSERT_TRUE(
        waitFor([this] { return button("Enable")->isEnabled() || button("Reference")->isEnabled(); }));
    button("Reference")->click();
    ASSERT_TRUE(waitFor([this] { return spoken("State") == "Disabled"; }));
    button("Enable")->click();
    ASSERT_TRUE(waitFor([this] { return spoken("State") == "Enabled"; }));
    window.motionPanel().showPage(MotionPanel::Jog);
    QPushButton* up = button("Jog +z");
    ASSERT_TRUE(up->isEnabled());
    QTest::mousePress(up, Qt::LeftButton);
    ASSERT_TRUE(waitFor([this] { return window.latest().measuredPose->offset[2] > 0.0005; }));
    QTest::mouseRelease(up, Qt::LeftButton);
    ASSERT_TRUE(waitFor([this] { return window.latest().state == RunState::Enabled; }));
    EXPECT_TRUE(happened("Jog started"));
    EXPECT_FALSE(window.motionPanel().jog().hold().direction());
}

/// A hold ends by Pause or Stop alone: what is refused leaves it, the list, the samples and the target alone.
TEST_F(OperatorWindowTest, NothingThatIsRefusedEndsAListOrItsHold) {
    button("Connect")->click();
    ASSERT_TRUE(waitFor([this] { return button("Run")->isEnabled() && spoken("Measured x") == "0.000"; }));
    WayPointsPanel& list = window.motionPanel().wayPoints();
    list.table().setPoses({poseOf(0, 0, 20, 0, 0, 0), poseOf(0, 0, -20, 0, 0, 0)});
    button("Play")->click();
    ASSERT_TRUE(waitFor([this] { return window.latest().state == RunState::Moving; }));
    button("Pause motion")->click();
    ASSERT_TRUE(waitFor([this] { return window.latest().held; }));
    type("Target z", "5");
    for (const char* name : {"Run", "Guided test", "Run report", "Play", "Step"}) {
        EXPECT_FALSE(button(name)->isEnabled()) << name;
        button(name)->click();
    }
    // Whoever asks all the same is refused by the loop.
    emit window.targetPanel().runRequested(poseOf(0, 0, 5, 0, 0, 0), 1234, {});
    window.reportPanel().runList({poseOf(1, 0, 0, 0, 0, 0)});
    ASSERT_TRUE(waitFor([this] { return !window.reportPanel().isRunning(); }));
    ASSERT_TRUE(waitFor([this] { return happened("cannot be carried out"); }));
    const std::uint64_t cycle = window.latest().cycle;
    ASSERT_TRUE(waitFor([&] { return window.latest().cycle > cycle + 20; }));
    EXPECT_TRUE(list.isRunning());
    EXPECT_TRUE(button("Pause motion")->isChecked());
    EXPECT_TRUE(window.latest().held);
    EXPECT_EQ(window.latest().state, RunState::Moving);
    EXPECT_EQ(spoken("Target z"), "5");
    button("Pause motion")->click(); // and goes on where it was
    ASSERT_TRUE(waitFor([this] { return spoken("Way-point progress").contains(QStringLiteral("2 of 2")); }));
    button("Stop")->click();
}

TEST_F(OperatorWindowTest, StopEndsAListAndSoDoesAnotherMotion) {
    button("Connect")->click();
    ASSERT_TRUE(waitFor([this] { return button("Run")->isEnabled() && spoken("Measured x") == "0.000"; }));
    WayPointsPanel& list = window.motionPanel().wayPoints();
    list.table().setPoses({poseOf(0, 0, 20, 0, 0, 0), poseOf(0, 0, -20, 0, 0, 0)});
    button("Play")->click();
    ASSERT_TRUE(waitFor([this] { return window.latest().state == RunState::Moving; }));
    EXPECT_TRUE(list.isRunning());
    EXPECT_EQ(spoken("Target z"), "20.00") << "the fields show where it goes";
    button("Pause motion")->click();
    ASSERT_TRUE(waitFor([this] { return window.latest().held; }));
    EXPECT_EQ(window.latest().state, RunState::Moving);
    button("Stop")->click();
    EXPECT_FALSE(list.isRunning());
    ASSERT_TRUE(waitFor([this] { return !window.latest().held; })) << "a stop ends the hold too";
    EXPECT_TRUE(spoken("Way-point progress").contains(QStringLiteral("Stopped while moving to way-point 1")));
    ASSERT_TRUE(waitFor([this] { return spoken("State") == "Stopped"; }));
    button("Clear")->click();
    ASSERT_TRUE(waitFor([this] { return spoken("State") == "Disabled"; }));
    button("Play")->click();
    EXPECT_TRUE(list.isRunning());
    // In the moment between two way-points another motion can come in.
    ASSERT_TRUE(waitFor([this] { return window.latest().state == RunState::Settling; }));
    window.session()->post(RunCommand{poseOf(0, 5, 0, 0, 0, 0), MotionMode::Joint, 1234});
    ASSERT_TRUE(waitFor([&list] { return !list.isRunning(); }));
    EXPECT_TRUE(spoken("Way-point progress").contains(QStringLiteral("another motion")));
    button("Stop")->click();
}

} // namespace
} // namespace hexapose
