// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/machine_state.h"
#include "tests/support/events.h"
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/common/number_field.h"
#include "ui/console/motion/guided_test_panel.h"
#include "ui/console/motion/jog_panel.h"
#include "ui/console/motion/motion_panel.h"
#include "ui/console/motion/speed_control.h"
#include "ui/console/motion/target_panel.h"
#include "ui/console/motion/way_point_table.h"
#include "ui/console/motion/way_points_panel.h"

#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace hexapose::testing;

class MotionPanelTest : public ::testing::Test {
protected:
    MotionPanelTest() : geometry(laboratoryPlatform()), panel(makeModel(geometry)) {
        QObject::connect(&panel, &MotionPanel::commandRequested,
                         [this](const OperatorCommand& command) { commands.push_back(command); });
        panel.show();
        live();
        commands.clear();
    }
    void live() {
        panel.setConnected(true);
        panel.showSnapshot(snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, 1.0));
    }
    bool isPlanned() {
        return QTest::qWaitFor(
            [this] {
                return !panel.target().isPlanning() && !panel.wayPoints().isPlanning() &&
                       !panel.guidedTest().isPlanning();
            },
            kPatienceMs);
    }
    QPushButton* button(const char* name) {
        return qobject_cast<QPushButton*>(findByName(panel, QString::fromLatin1(name)));
    }

    PlatformGeometry geometry;
    MotionPanel panel;
    std::vector<OperatorCommand> commands;
    MotionId lastAsked = kNoMotion;
};

TEST_F(MotionPanelTest, ModeGoesWithRunAndChangingItStartsNothing) {
    auto* mode = qobject_cast<QComboBox*>(findByName(panel, QStringLiteral("Mode")));
    ASSERT_NE(mode, nullptr);
    EXPECT_EQ(panel.mode(), MotionMode::Joint);
    mode->setCurrentIndex(1);
    EXPECT_TRUE(commands.empty());
    for (const int index : {1, 0}) {
        mode->setCurrentIndex(index);
        ASSERT_TRUE(isPlanned());
        button("Run")->click();
    }
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_EQ(std::get<RunCommand>(commands[0]).mode, MotionMode::Workspace);
    EXPECT_EQ(std::get<RunCommand>(commands[1]).mode, MotionMode::Joint);
    for (const OperatorCommand& command : commands) {
        const auto& run = std::get<RunCommand>(command);
        ASSERT_TRUE(run.plan);
        EXPECT_TRUE(run.plan->isFor({run.target, run.mode}));
    }
}

TEST_F(MotionPanelTest, SpeedIsSentAsItIsChosenAndAgainWhereTheLoopHasAnother) {
    auto* slider = qobject_cast<QSlider*>(findByName(panel, QStringLiteral("Speed")));
    ASSERT_NE(slider, nullptr);
    EXPECT_EQ(slider->minimum(), 5);
    EXPECT_EQ(slider->maximum(), 100);
    slider->setValue(25);
    ASSERT_EQ(commands.size(), 1U);
    EXPECT_DOUBLE_EQ(std::get<SpeedCommand>(commands[0]).speedOverride, 0.25);
    EXPECT_EQ(spokenText(panel, QStringLiteral("Speed in force")), "25 %");
    panel.sessionOpened();
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_DOUBLE_EQ(std::get<SpeedCommand>(commands[1]).speedOverride, 0.25);
    Snapshot other = snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, 1.0);
    other.speed = 1.0;
    ASSERT_TRUE(QTest::qWaitFor([&] {
        panel.showSnapshot(other);
        return commands.size() > 2;
    }));
    EXPECT_DOUBLE_EQ(std::get<SpeedCommand>(commands[2]).speedOverride, 0.25);
}

TEST_F(MotionPanelTest, AMotionIsHeldAndGoesOnAtTheOldSpeed) {
    Snapshot moving = snapshotAt(geometry, Pose{}, Pose{}, RunState::Moving, 1.0);
    panel.showSnapshot(moving);
    button("Pause motion")->click();
    ASSERT_EQ(commands.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<HoldCommand>(commands[0]));
    moving.held = true;
    moving.allowed = allowedCommands({.run = RunState::Moving, .hasControl = true, .held = true});
    panel.showSnapshot(moving);
    EXPECT_EQ(spokenText(panel, QStringLiteral("Speed in force")), "held");
    button("Pause motion")->click();
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<ResumeCommand>(commands[1]));
    panel.showSnapshot(snapshotAt(geometry, Pose{}, Pose{}, RunState::Moving, 1.1));
    EXPECT_EQ(spokenText(panel, QStringLiteral("Speed in force")), "100 %");
}

TEST_F(MotionPanelTest, AListEndsWithAnotherMotionThatIsAcceptedAndNotWithAWish) {
    double now = 1.0;
    MotionId id = kNoMotion; // of the motion that the loop has
    QObject::connect(&panel.wayPoints(), &WayPointsPanel::runRequested,
                     [this](const Pose&, MotionId asked) { lastAsked = asked; });
    const auto feed = [&](RunState state, std::vector<Event> events = {}) {
        Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, state, now += 0.01);
        snapshot.events = std::move(events);
        snapshot.motionId = id;
        panel.add(snapshot);
        panel.showSnapshot(snapshot);
    };
    for (const EventCode other : {EventCode::MoveStarted, EventCode::JogStarted}) {
        panel.target().setTarget(poseOf(7, 0, 0, 0, 0, 0));
        panel.wayPoints().table().setPoses({poseOf(1, 0, 0, 0, 0, 0), poseOf(2, 0, 0, 0, 0, 0)});
        feed(RunState::Enabled);
        button("Play")->click();
        ASSERT_TRUE(isPlanned());
        feed(RunState::Enabled);
        EXPECT_EQ(spokenText(panel, QStringLiteral("Target x")), "7.00") << "nothing has begun";
        id = lastAsked;
        feed(RunState::Moving, {{EventCode::MoveStarted, 1.0}});
        EXPECT_EQ(spokenText(panel, QStringLiteral("Target x")), "1.00");
        // In mid-move whatever is asked for is refused, and changes nothing.
        for (const char* name : {"Run", "Guided test", "Play", "Step"}) {
            EXPECT_FALSE(button(name)->isEnabled()) << name;
        }
        emit panel.jog().jogRequested({}, 1234);
        emit panel.target().runRequested(poseOf(3, 0, 0, 0, 0, 0), 1235, {});
        panel.guidedTest().start();
        feed(RunState::Moving,
             {eventFrom("command-refused jog in moving"), eventFrom("command-refused run in moving")});
        EXPECT_TRUE(panel.wayPoints().isRunning());
        EXPECT_FALSE(panel.guidedTest().isRunning());
        EXPECT_EQ(spokenText(panel, QStringLiteral("Target x")), "1.00");
        feed(RunState::Settling);
        id = 1236;
        feed(RunState::Moving, {{other}});
        EXPECT_FALSE(panel.wayPoints().isRunning());
        EXPECT_EQ(spokenText(panel, QStringLiteral("Way-point progress")),
                  "Ended at way-point 1: another motion was commanded");
    }
}

TEST_F(MotionPanelTest, StopIsAlwaysThereAndOnOneKey) {
    QSignalSpy stops(&panel, &MotionPanel::stopRequested);
    panel.setConnected(false);
    EXPECT_TRUE(button("Stop")->isEnabled());
    button("Stop")->click();
    panel.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
    for (const auto page :
         {MotionPanel::Target, MotionPanel::Jog, MotionPanel::WayPoints, MotionPanel::Test}) {
        panel.showPage(page);
        EXPECT_TRUE(button("Stop")->isVisible()) << page;
        QTest::keyClick(&panel, Qt::Key_Escape);
    }
    EXPECT_EQ(stops.count(), 5);
}

} // namespace
} // namespace hexapose
