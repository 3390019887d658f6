// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/machine_state.h"
#include "core/record/pose_list.h"
#include "tests/support/events.h"
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/common/language.h"
#include "ui/console/motion/way_point_table.h"
#include "ui/console/motion/way_points_panel.h"

#include <QCoreApplication>
#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace hexapose::testing;

class WayPointsTest : public ::testing::Test {
protected:
    WayPointsTest() : geometry(laboratoryPlatform()), panel(makeModel(geometry)) {
        QObject::connect(&panel, &WayPointsPanel::runRequested,
                         [this](const Pose& pose, MotionId id, const SharedPlan& plan) {
                             asked.push_back(pose);
                             plans.push_back(plan);
                             lastId = id;
                         });
        QObject::connect(&panel, &WayPointsPanel::holdRequested, [this](bool on) { holds.push_back(on); });
        panel.show();
        panel.setConnected(true);
        panel.showSnapshot(snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, now));
    }
    /// Plans come by events, so that none has come before this.
    bool isPlanned() {
        return QTest::qWaitFor([this] { return !panel.isPlanning(); }, kPatienceMs);
    }
    void feed(const Pose& at, RunState state, std::vector<Event> events = {}) {
        ASSERT_TRUE(isPlanned());
        Snapshot snapshot = snapshotAt(geometry, at, at, state, now += 0.01);
        snapshot.events = std::move(events);
        snapshot.motionId = lastId;
        panel.add(snapshot);
    }
    /// As the screen sees it.
    void show(RunState state, bool held = false) {
        Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, state, now);
        snapshot.allowed = allowedCommands({.run = state, .hasControl = true, .held = held});
        snapshot.held = held;
        snapshot.motionId = lastId;
        panel.showSnapshot(snapshot);
    }
    QPushButton* button(const char* name) {
        return qobject_cast<QPushButton*>(findByName(panel, QString::fromLatin1(name)));
    }
    std::string message() { return spokenText(panel, QStringLiteral("Way-point progress")).toStdString(); }
    void settleAt(const Pose& pose) {
        feed(pose, RunState::Moving, {{EventCode::MoveStarted, 2.0}});
        feed(pose, RunState::Enabled, {{EventCode::Settled, 1.0}});
    }

    PlatformGeometry geometry;
    WayPointsPanel panel;
    std::vector<Pose> asked;
    std::vector<SharedPlan> plans; ///< sent with them
    MotionId lastId = kNoMotion;
    std::vector<bool> holds;
    const std::vector<Pose> three{poseOf(5, 0, 0, 0, 0, 0), poseOf(5, 5, 0, 0, 0, 0),
                                  poseOf(0, 5, 0, 0, 0, 2)};
    double now = 0.0;
};

TEST_F(WayPointsTest, PlayVisitsThemAllOneAfterTheOther) {
    panel.table().setPoses(three);
    button("Play")->click();
    feed(Pose{}, RunState::Enabled);
    for (std::size_t i = 0; i < three.size(); ++i) {
        ASSERT_EQ(asked.size(), i + 1);
        EXPECT_TRUE(asked[i].toVector().isApprox(three[i].toVector(), 1e-9));
        EXPECT_EQ(panel.table().marked(), static_cast<int>(i));
        EXPECT_NE(message().find("way-point " + std::to_string(i + 1) + " of 3"), std::string::npos)
            << message();
        settleAt(three[i]);
    }
    EXPECT_FALSE(panel.isRunning());
    EXPECT_EQ(panel.table().marked(), -1);
    EXPECT_EQ(message(), "All 3 way-points visited");
    EXPECT_EQ(asked.size(), 3U);
}

TEST_F(WayPointsTest, EachRunSendsThePlanThatWasCheckedAtThePress) {
    panel.setMode(MotionMode::Workspace);
    panel.table().setPoses(three);
    button("Play")->click();
    EXPECT_TRUE(panel.isRunning());
    EXPECT_FALSE(button("Play")->isEnabled());
    EXPECT_FALSE(button("Add measured")->isEnabled()) << "the list stays as it was pressed";
    feed(Pose{}, RunState::Enabled);
    Pose from;
    for (std::size_t i = 0; i < three.size(); ++i) {
        ASSERT_EQ(plans.size(), i + 1);
        ASSERT_TRUE(plans[i]);
        EXPECT_TRUE(plans[i]->isFor({asked[i], MotionMode::Workspace}));
        EXPECT_TRUE(plans[i]->start.pose.toVector().isApprox(from.toVector(), 1e-12));
        EXPECT_TRUE(plans[i]->motion);
        from = asked[i];
        settleAt(three[i]);
    }
    EXPECT_FALSE(panel.isRunning());
}

TEST_F(WayPointsTest, StopWhileTheListIsPlannedStartsNothing) {
    panel.table().setPoses(three);
    button("Play")->click();
    ASSERT_TRUE(panel.isPlanning());
    panel.stopped(); // returns at once
    EXPECT_FALSE(panel.isRunning());
    EXPECT_FALSE(panel.isPlanning());
    QTest::qWait(0);
    feed(Pose{}, RunState::Enabled);
    EXPECT_TRUE(asked.empty());
    EXPECT_TRUE(button("Play")->isEnabled());
}

TEST_F(WayPointsTest, APlatformThatIsNoLongerReadyIsLeftAlone) {
    panel.table().setPoses(three);
    button("Play")->click();
    show(RunState::Moving); // somebody else's motion
    ASSERT_TRUE(isPlanned());
    EXPECT_FALSE(panel.isRunning());
    EXPECT_EQ(message(), "The platform is not ready any more. Nothing moved.");
}

TEST_F(WayPointsTest, StepVisitsTheNextOneOnly) {
    panel.table().setPoses(three);
    for (const std::size_t expected : {0U, 1U, 2U, 0U}) {
        button("Step")->click();
        feed(Pose{}, RunState::Enabled);
        ASSERT_FALSE(asked.empty());
        EXPECT_TRUE(asked.back().toVector().isApprox(three[expected].toVector(), 1e-9));
        settleAt(three[expected]);
        EXPECT_FALSE(panel.isRunning());
    }
    EXPECT_EQ(asked.size(), 4U);
}

TEST_F(WayPointsTest, ABadRowIsNamedBeforeAnythingMoves) {
    panel.table().setPoses({three[0], poseOf(0, 0, 200, 0, 0, 0), three[2]});
    button("Play")->click();
    ASSERT_TRUE(isPlanned());
    EXPECT_FALSE(panel.isRunning());
    EXPECT_EQ(message().rfind("Row 2: Leg ", 0), 0U) << message();
    panel.table().setPoses(three);
    panel.table().item(2, 1)->setText(QStringLiteral("5.5.5"));
    EXPECT_EQ(message(), "Row 3: y: two decimal marks");
    EXPECT_FALSE(button("Play")->isEnabled());
    panel.play();
    EXPECT_FALSE(panel.isRunning());
    feed(Pose{}, RunState::Enabled);
    EXPECT_TRUE(asked.empty());
}

TEST_F(WayPointsTest, PauseHoldsAndReleases) {
    panel.table().setPoses(three);
    EXPECT_FALSE(button("Pause motion")->isEnabled());
    button("Play")->click();
    feed(Pose{}, RunState::Enabled);
    feed(Pose{}, RunState::Moving, {{EventCode::MoveStarted, 2.0}});
    show(RunState::Moving);
    button("Pause motion")->click();
    show(RunState::Moving); // not yet answered: it is not asked for again
    EXPECT_EQ(holds, std::vector<bool>{true});
    EXPECT_TRUE(button("Pause motion")->isChecked());
    show(RunState::Moving, true);
    EXPECT_TRUE(button("Pause motion")->isChecked());
    button("Pause motion")->click();
    EXPECT_EQ(holds, (std::vector<bool>{true, false}));
    show(RunState::Moving);
    EXPECT_FALSE(button("Pause motion")->isChecked());
    button("Pause motion")->click();
    panel.stopped();
    show(RunState::Stopped);
    EXPECT_EQ(holds, (std::vector<bool>{true, false, true})) << "the loop lets go by itself";
    EXPECT_FALSE(button("Pause motion")->isChecked());
}

/// There the loop has nothing to hold.
TEST_F(WayPointsTest, PauseBetweenTwoWayPointsKeepsTheNextBack) {
    panel.table().setPoses(three);
    button("Play")->click();
    feed(Pose{}, RunState::Enabled);
    feed(three[0], RunState::Moving, {{EventCode::MoveStarted, 2.0}});
    show(RunState::Settling);
    button("Pause motion")->click();
    feed(three[0], RunState::Enabled, {{EventCode::Settled, 1.0}});
    show(RunState::Enabled);
    EXPECT_EQ(asked.size(), 1U);
    EXPECT_TRUE(panel.isRunning());
    EXPECT_TRUE(button("Pause motion")->isChecked());
    button("Pause motion")->click();
    EXPECT_EQ(asked.size(), 2U);
    EXPECT_TRUE(holds.empty());
    // Pressed before the motion begins that was asked for: held when it does.
    button("Pause motion")->click();
    feed(three[0], RunState::Moving, {{EventCode::MoveStarted, 2.0}});
    show(RunState::Moving);
    EXPECT_EQ(holds, std::vector<bool>{true});
}

TEST_F(WayPointsTest, AHoldOutlivesTheList) {
    panel.table().setPoses(three);
    button("Play")->click();
    feed(Pose{}, RunState::Enabled);
    feed(Pose{}, RunState::Moving, {{EventCode::MoveStarted, 2.0}});
    show(RunState::Moving, true);
    lastId = 1234; // another motion has taken over
    feed(Pose{}, RunState::Moving);
    EXPECT_FALSE(panel.isRunning());
    show(RunState::Moving, true);
    EXPECT_TRUE(button("Pause motion")->isChecked());
    EXPECT_TRUE(button("Pause motion")->isEnabled());
    EXPECT_TRUE(holds.empty());
    button("Pause motion")->click();
    EXPECT_EQ(holds, std::vector<bool>{false});
}

TEST_F(WayPointsTest, RowsAreNumberedAnewAfterARemoval) {
    panel.table().setPoses(three);
    panel.table().setCurrentCell(1, 0);
    button("Remove way-point")->click();
    ASSERT_EQ(panel.table().rowCount(), 2);
    EXPECT_EQ(panel.table().verticalHeaderItem(0)->text(), "1");
    EXPECT_EQ(panel.table().verticalHeaderItem(1)->text(), "2");
}

TEST_F(WayPointsTest, ARefusalAFaultAndAStopEndItWithTheirReason) {
    const std::pair<Event, const char*> ends[] = {
        {eventFrom("move-refused leg 3 above max_mm"), "Leg 3 would be above"},
        {eventFrom("controller-fault overheated"), "overheated"},
        {{EventCode::StoppedOnStaleData}, "no measurements received"}};
    for (const auto& [event, words] : ends) {
        asked.clear();
        panel.table().setPoses(three);
        button("Play")->click();
        feed(Pose{}, RunState::Enabled);
        settleAt(three[0]);
        feed(three[0], RunState::Moving, {event});
        EXPECT_FALSE(panel.isRunning());
        EXPECT_NE(message().find("way-point 2"), std::string::npos) << message();
        EXPECT_NE(message().find(words), std::string::npos) << message();
        feed(three[0], RunState::Enabled);
        EXPECT_EQ(asked.size(), 2U);
    }
    button("Play")->click();
    panel.stopped();
    EXPECT_EQ(message().rfind("Stopped while moving to way-point 1", 0), 0U) << message();
}

TEST_F(WayPointsTest, RowsAreAddedMovedAndRemoved) {
    panel.setTargetSource([this] { return std::optional(three[1]); });
    button("Add measured")->click();
    button("Add target")->click();
    ASSERT_EQ(panel.table().rowCount(), 2);
    EXPECT_EQ(panel.table().item(1, 1)->text(), "5");
    button("Move up")->click();
    EXPECT_EQ(panel.table().item(0, 1)->text(), "5");
    EXPECT_FALSE(button("Move up")->isEnabled());
    button("Remove way-point")->click();
    ASSERT_EQ(panel.table().rowCount(), 1);
    EXPECT_EQ(panel.table().item(0, 1)->text(), "0");
    EXPECT_TRUE(asked.empty());
}

TEST_F(WayPointsTest, AListComesBackFromItsFile) {
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("list.csv"));
    panel.table().setPoses(three);
    panel.save(file);
    EXPECT_EQ(message(), "Saved as " + file.toStdString());
    const std::vector<Pose> read = readPoseList(file.toStdString());
    ASSERT_EQ(read.size(), 3U);
    EXPECT_TRUE(read[2].toVector().isApprox(three[2].toVector(), 1e-9));
    panel.table().setPoses({});
    panel.load(file);
    ASSERT_EQ(panel.table().rowCount(), 3);
    EXPECT_EQ(panel.table().item(2, 5)->text(), "2");
    QFile bad(folder.filePath(QStringLiteral("bad.csv")));
    ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
    bad.write("x_mm,y_mm\n1,2\n");
    bad.close();
    panel.load(bad.fileName());
    EXPECT_EQ(message(), "The list cannot be used: " + bad.fileName().toStdString() +
                             ", line 1: column z_mm is missing");
    LanguageSwitch language;
    ASSERT_TRUE(language.choose(QStringLiteral("zh_CN")));
    QCoreApplication::sendPostedEvents();
    EXPECT_FALSE(
        spokenText(panel, WayPointsPanel::tr("Way-point progress")).contains(QStringLiteral("missing")));
    ASSERT_TRUE(language.choose(QStringLiteral("en")));
    QCoreApplication::sendPostedEvents();
    EXPECT_EQ(panel.table().rowCount(), 3) << "what was there stays";
    panel.save(QStringLiteral("/proc/none/list.csv"));
    EXPECT_EQ(message().rfind("The list cannot be saved", 0), 0U) << message();
}

} // namespace
} // namespace hexapose
