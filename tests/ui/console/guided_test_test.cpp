// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/events.h"
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/common/theme.h"
#include "ui/console/motion/guided_test_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

#include <utility>

namespace hexapose {
namespace {

using namespace hexapose::testing;

class GuidedTestTest : public ::testing::Test {
protected:
    GuidedTestTest() : geometry(laboratoryPlatform()), panel(makeModel(geometry)) {
        QObject::connect(&panel, &GuidedTestPanel::runRequested,
                         [this](const Pose& pose, MotionId id, const SharedPlan& plan) {
                             asked.push_back(pose);
                             plans.push_back(plan);
                             lastId = id;
                         });
        panel.setSolver(newtonSolver(geometry));
        panel.setConnected(true);
        panel.showSnapshot(snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, now));
    }
    /// Plans come by events, so that none has come before this.
    bool isPlanned() {
        return QTest::qWaitFor([this] { return !panel.isPlanning(); }, kPatienceMs);
    }
    void feed(const Pose& at, RunState state, std::vector<Event> events = {}) {
        ASSERT_TRUE(isPlanned());
        Snapshot snapshot = snapshotAt(geometry, at, published, state, now += 0.01);
        snapshot.events = std::move(events);
        snapshot.motionId = lastId;
        panel.add(snapshot);
    }
    QPushButton* button() {
        return qobject_cast<QPushButton*>(findByName(panel, QStringLiteral("Guided test")));
    }
    QString spoken(const char* name) { return spokenText(panel, QString::fromLatin1(name)); }
    int activeStep() {
        const auto lamps = panel.findChildren<QLabel*>(QStringLiteral("lamp"));
        for (int i = 0; i < lamps.size(); ++i) {
            if (toneOf(*lamps[i]) == Tone::Warn) {
                return i;
            }
        }
        return -1;
    }

    PlatformGeometry geometry;
    GuidedTestPanel panel;
    const Pose published = poseOf(12, -4, 40, 0, 0, 5);
    std::vector<Pose> asked;
    std::vector<SharedPlan> plans; ///< sent with them
    MotionId lastId = kNoMotion;
    double now = 0.0;
};

TEST_F(GuidedTestTest, GoesThereSettlesAveragesSolvesAndCompares) {
    button()->click();
    EXPECT_FALSE(button()->isEnabled());
    feed(Pose{}, RunState::Enabled);
    ASSERT_EQ(asked.size(), 1U);
    ASSERT_TRUE(plans[0]);
    EXPECT_TRUE(plans[0]->isFor({asked[0], MotionMode::Joint}));
    EXPECT_TRUE(asked[0].toVector().isApprox(published.toVector(), 1e-12));
    EXPECT_EQ(activeStep(), 0);
    const Pose there = poseOf(12.002, -4, 40, 0, 0, 5.01);
    feed(there, RunState::Moving, {{EventCode::MoveStarted, 2.0}});
    feed(there, RunState::Settling);
    EXPECT_EQ(activeStep(), 1);
    feed(there, RunState::Enabled, {{EventCode::Settled, 1.0}});
    EXPECT_EQ(activeStep(), 2);
    for (int i = 0; i < 120; ++i) {
        feed(there, RunState::Enabled);
    }
    EXPECT_FALSE(panel.isRunning());
    EXPECT_EQ(spoken("Test target x"), "12.000");
    EXPECT_EQ(spoken("Test measured x"), "12.002");
    EXPECT_EQ(spoken("Test error x"), "0.002");
    EXPECT_EQ(spoken("Test error gamma"), "0.010");
    EXPECT_GT(spoken("Test length 1").toDouble(), 300.0);
    EXPECT_TRUE(spoken("Test progress").startsWith(QStringLiteral("Done")))
        << spoken("Test progress").toStdString();
    EXPECT_TRUE(button()->isEnabled());
    EXPECT_EQ(asked.size(), 1U);
}

TEST_F(GuidedTestTest, ARefusalLeavesTheLastResult) {
    button()->click();
    feed(Pose{}, RunState::Enabled);
    feed(published, RunState::Moving, {{EventCode::MoveStarted, 2.0}});
    feed(published, RunState::Enabled, {{EventCode::Settled, 1.0}});
    for (int i = 0; i < 120; ++i) {
        feed(published, RunState::Enabled);
    }
    ASSERT_EQ(spoken("Test measured z"), "40.000");
    button()->click();
    const MotionId before = lastId;
    feed(published, RunState::Enabled);
    EXPECT_NE(lastId, before);
    const MotionId refused = std::exchange(lastId, before); // the loop has not taken it
    feed(
        published, RunState::Moving,
        {{EventCode::CommandRefused, CommandRefusal{Command::Run, RunState::Moving, CommandSet{}, refused}}});
    EXPECT_FALSE(panel.isRunning());
    EXPECT_EQ(spoken("Test measured z"), "40.000");
}

TEST_F(GuidedTestTest, StopAndAFailureEndItWithoutAResult) {
    button()->click();
    feed(Pose{}, RunState::Enabled);
    panel.stopped();
    EXPECT_FALSE(panel.isRunning());
    EXPECT_EQ(activeStep(), -1);
    EXPECT_EQ(spoken("Test measured x"), "--");
    EXPECT_TRUE(spoken("Test progress").contains(QStringLiteral("Stop")));
    button()->click();
    feed(Pose{}, RunState::Enabled);
    feed(Pose{}, RunState::Moving, {eventFrom("controller-fault overheated")});
    EXPECT_FALSE(panel.isRunning());
    EXPECT_TRUE(spoken("Test progress").contains(QStringLiteral("overheated")));
}

TEST_F(GuidedTestTest, StopWhileItIsPlannedStartsNothing) {
    button()->click();
    EXPECT_TRUE(panel.isPlanning());
    panel.stopped();
    EXPECT_FALSE(panel.isRunning());
    feed(Pose{}, RunState::Enabled);
    EXPECT_TRUE(asked.empty());
    EXPECT_TRUE(button()->isEnabled());
}

TEST(GuidedPlan, IsSmallerWhereTheMachineReachesLess) {
    PlatformGeometry small = laboratoryPlatform();
    for (Leg& leg : small.legs) {
        leg.minLength = 0.290;
        leg.maxLength = 0.312;
    }
    const MotionPlanner planner(makeModel(small), plannerSettings({}, small));
    const SharedPlan plan = guidedPlan(planner, {small.homeLengths(), Pose{}}, MotionMode::Workspace);
    ASSERT_TRUE(plan);
    EXPECT_TRUE(plan->check.ok());
    EXPECT_EQ(plan->mode(), MotionMode::Workspace);
    EXPECT_LT(plan->endPose().offset[2], 0.040);
    EXPECT_GT(plan->endPose().offset[2], 0.001);
}

} // namespace
} // namespace hexapose
