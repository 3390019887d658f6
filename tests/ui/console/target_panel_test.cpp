// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/common/number_field.h"
#include "ui/console/events/motion_check_text.h"
#include "ui/console/motion/named_poses.h"
#include "ui/console/motion/target_panel.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace hexapose::testing;

class TargetPanelTest : public ::testing::Test {
protected:
    TargetPanelTest() : geometry(laboratoryPlatform()), panel(makeModel(geometry)) { panel.show(); }

    void type(const char* field, const char* text) {
        auto* found = qobject_cast<NumberField*>(findByName(panel, QString::fromLatin1(field)));
        ASSERT_NE(found, nullptr) << field;
        found->selectAll();
        QTest::keyClicks(found, QString::fromLatin1(text));
        ASSERT_TRUE(isPlanned());
    }
    /// Plans come by events, so that none has come before this.
    bool isPlanned() {
        return QTest::qWaitFor([this] { return !panel.isPlanning(); }, kPatienceMs);
    }
    QPushButton* button(const char* name) {
        return qobject_cast<QPushButton*>(findByName(panel, QString::fromLatin1(name)));
    }
    QString validity() { return spokenText(panel, QStringLiteral("Validity")); }
    void show(const Snapshot& snapshot) {
        panel.showSnapshot(snapshot);
        ASSERT_TRUE(isPlanned());
    }
    void live(const Pose& pose) {
        show(snapshotAt(geometry, pose, pose, RunState::Enabled, 1.0));
        panel.setConnected(true);
    }

    PlatformGeometry geometry;
    TargetPanel panel;
};

TEST_F(TargetPanelTest, RunIsDisabledWithItsReasonWhileTheStateIsNotKnown) {
    live(Pose{});
    EXPECT_TRUE(button("Run")->isEnabled());
    EXPECT_EQ(validity(), "Reachable");
    const Snapshot good = snapshotAt(geometry, Pose{}, Pose{}, RunState::Disabled, 1.0);
    Snapshot old = good;
    old.stale = true;
    Snapshot plain = good;
    plain.link = LinkState::ListenOnly;
    for (const auto& [snapshot, word] : {std::pair(old, "measurement"), std::pair(plain, "no commands")}) {
        show(snapshot);
        EXPECT_FALSE(button("Run")->isEnabled()) << word;
        EXPECT_TRUE(button("Run")->toolTip().contains(QString::fromLatin1(word)));
        EXPECT_TRUE(validity().contains(QString::fromLatin1(word))) << validity().toStdString();
    }
    show(good);
    EXPECT_TRUE(button("Run")->isEnabled());
    EXPECT_EQ(validity(), "Reachable");
    panel.setConnected(false);
    EXPECT_FALSE(button("Run")->isEnabled());
    EXPECT_TRUE(button("Run")->toolTip().contains(QStringLiteral("nothing is connected")));
    EXPECT_TRUE(validity().contains(QStringLiteral("nothing is connected")));
    type("Target z", "200"); // the target is checked all the same
    EXPECT_TRUE(validity().contains(QStringLiteral("above its maximum"))) << validity().toStdString();
}

TEST_F(TargetPanelTest, TheNameOfAPoseHasAnEditorOfThatName) {
    auto* box = panel.namedPoses().findChild<QComboBox*>();
    ASSERT_NE(box, nullptr);
    box->setEditText(QStringLiteral("high"));
    EXPECT_EQ(box->lineEdit()->accessibleName(), "Pose name");
    EXPECT_EQ(spokenText(box->lineEdit()), "high");
}

TEST_F(TargetPanelTest, AWrongFieldIsMarkedAsLongAsItIs) {
    auto* z = qobject_cast<NumberField*>(findByName(panel, QStringLiteral("Target z")));
    ASSERT_NE(z, nullptr);
    type("Target z", "-");
    EXPECT_TRUE(z->property("wrong").toBool());
    panel.setTarget(Pose{}); // the value it had before
    EXPECT_FALSE(z->isRefused());
    EXPECT_FALSE(z->property("wrong").toBool());
}

TEST_F(TargetPanelTest, RunWaitsForClearAfterAStopOrFault) {
    live(Pose{});
    for (const RunState state : {RunState::Stopped, RunState::Fault}) {
        show(snapshotAt(geometry, Pose{}, Pose{}, state, 1.0));
        EXPECT_FALSE(button("Run")->isEnabled());
        EXPECT_TRUE(validity().contains(QStringLiteral("Clear"))) << validity().toStdString();
    }
    show(snapshotAt(geometry, Pose{}, Pose{}, RunState::Disabled, 1.0));
    EXPECT_TRUE(button("Run")->isEnabled());
}

TEST_F(TargetPanelTest, ValidityFollowsTheTypingAndSaysWhyNot) {
    EXPECT_EQ(validity(), "Reachable, but nothing is connected");
    panel.setConnected(true);
    EXPECT_EQ(validity(), "Reachable");
    type("Target z", "200");
    ASSERT_TRUE(panel.check());
    EXPECT_FALSE(panel.check()->ok());
    EXPECT_TRUE(validity().contains(QStringLiteral("above its maximum 350 mm"))) << validity().toStdString();
    type("Target z", "-");
    EXPECT_FALSE(panel.check());
    EXPECT_EQ(validity(), "Target z: unfinished");
    type("Target z", "40");
    EXPECT_EQ(validity(), "Reachable");
}

TEST_F(TargetPanelTest, RunIsGreyBesideARedVerdictAndInMidMoveWithTheReason) {
    live(Pose{});
    type("Target z", "200");
    EXPECT_FALSE(button("Run")->isEnabled());
    EXPECT_EQ(button("Run")->toolTip(), validity());
    EXPECT_EQ(button("Run")->accessibleDescription(), validity());
    type("Target z", "20");
    EXPECT_TRUE(button("Run")->isEnabled());
    show(snapshotAt(geometry, Pose{}, Pose{}, RunState::Moving, 1.1));
    EXPECT_FALSE(button("Run")->isEnabled());
    EXPECT_EQ(validity(), "Cannot run while the platform moves");
    // A press that comes all the same, as from a program, asks for nothing.
    QSignalSpy runs(&panel, &TargetPanel::runRequested);
    panel.run();
    EXPECT_EQ(runs.count(), 0);
}

TEST_F(TargetPanelTest, LimitsOfTheControllerNarrowThoseOfThePlatform) {
    Snapshot snapshot = snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, 1.0);
    const LegLengths home = geometry.homeLengths();
    snapshot.maxLength = home.maxCoeff() + 0.001;
    show(snapshot);
    type("Target z", "30");
    EXPECT_EQ(panel.check()->reason, MotionCheck::Reason::LegAboveMax);
    EXPECT_NEAR(panel.check()->bound, *snapshot.maxLength, 1e-12);
}

TEST_F(TargetPanelTest, RunGivesTheTypedTargetAndOnlyAWholeOne) {
    QSignalSpy runs(&panel, &TargetPanel::runRequested);
    std::optional<Pose> asked;
    QObject::connect(&panel, &TargetPanel::runRequested, [&](const Pose& pose) { asked = pose; });
    EXPECT_FALSE(button("Run")->isEnabled());
    live(Pose{});
    const std::pair<const char*, const char*> typed[] = {{"Target x", "12"},   {"Target y", "-4"},
                                                         {"Target z", "40"},   {"Target alpha", "0"},
                                                         {"Target beta", "0"}, {"Target gamma", "5"}};
    for (const auto& [field, text] : typed) {
        type(field, text);
    }
    button("Run")->click();
    ASSERT_TRUE(asked);
    EXPECT_TRUE(asked->toVector().isApprox(poseOf(12, -4, 40, 0, 0, 5).toVector(), 1e-12));
    type("Target beta", "-");
    button("Run")->click();
    EXPECT_EQ(runs.count(), 1);
}

TEST_F(TargetPanelTest, ResetAndCopyFillTheFieldsAndMoveNothing) {
    QSignalSpy runs(&panel, &TargetPanel::runRequested);
    EXPECT_FALSE(button("Copy measured")->isEnabled());
    const Pose here = poseOf(1.5, 2.25, -3, 1, 0.5, -2);
    live(here);
    button("Copy measured")->click();
    EXPECT_TRUE(panel.target()->toVector().isApprox(here.toVector(), 1e-6));
    EXPECT_EQ(spokenText(panel, QStringLiteral("Target y")), "2.25");
    button("Reset")->click();
    EXPECT_TRUE(panel.target()->toVector().isZero());
    EXPECT_EQ(runs.count(), 0);
}

TEST_F(TargetPanelTest, PosesAreKeptChosenReplacedAndRemovedByTheirNames) {
    QSignalSpy runs(&panel, &TargetPanel::runRequested);
    QSignalSpy changes(&panel.namedPoses(), &NamedPoses::changed);
    auto* box = qobject_cast<QComboBox*>(findByName(panel, QStringLiteral("Pose name")));
    ASSERT_NE(box, nullptr);
    live(Pose{});
    EXPECT_FALSE(button("Save pose")->isEnabled());
    const auto keep = [&](const char* name, const char* z) {
        type("Target z", z);
        box->setFocus();
        box->lineEdit()->selectAll();
        QTest::keyClicks(box->lineEdit(), QString::fromUtf8(name));
        button("Save pose")->click();
    };
    keep("loading", "30");
    keep("a scan", "-5");
    keep("loading", "31");
    ASSERT_EQ(panel.namedPoses().poses().size(), 2U);
    EXPECT_EQ(panel.namedPoses().poses()[0].name, QStringLiteral("a scan"));
    EXPECT_NEAR(panel.namedPoses().poses()[1].pose.offset[2], 0.031, 1e-12);

    box->setFocus();
    QTest::keyClick(box, Qt::Key_Up); // the first of two
    EXPECT_NEAR(panel.target()->offset[2], -0.005, 1e-12);
    type("Target z", "-");
    EXPECT_FALSE(button("Save pose")->isEnabled()) << "there is no whole pose to keep";
    EXPECT_TRUE(button("Remove pose")->isEnabled());
    button("Remove pose")->click();
    EXPECT_FALSE(button("Remove pose")->isEnabled());
    EXPECT_EQ(panel.namedPoses().poses().size(), 1U);
    EXPECT_EQ(changes.count(), 4);
    EXPECT_EQ(runs.count(), 0);
}

TEST_F(TargetPanelTest, ANameThatIsTypedLoadsNothing) {
    panel.namedPoses().setPoses({{QStringLiteral("park"), poseOf(0, 0, 30, 0, 0, 0)}});
    panel.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
    live(Pose{});
    auto* box = panel.namedPoses().findChild<QComboBox*>();
    ASSERT_NE(box, nullptr);
    const auto typeName = [&] {
        QTest::mouseClick(box->lineEdit(), Qt::LeftButton);
        ASSERT_EQ(QApplication::focusWidget(), box);
        box->lineEdit()->selectAll();
        QTest::keyClicks(box, QStringLiteral("park"));
    };
    std::optional<Pose> asked;
    QObject::connect(&panel, &TargetPanel::runRequested, [&](const Pose& pose) { asked = pose; });
    type("Target z", "5");
    typeName();
    button("Run")->setFocus(Qt::MouseFocusReason); // as a click does
    QTest::mouseClick(button("Run"), Qt::LeftButton);
    ASSERT_TRUE(asked);
    EXPECT_NEAR(asked->offset[2], 0.005, 1e-12);

    typeName();
    QTest::keyClick(box, Qt::Key_Return);
    EXPECT_NEAR(panel.target()->offset[2], 0.005, 1e-12);
    button("Save pose")->setFocus(Qt::MouseFocusReason);
    QTest::mouseClick(button("Save pose"), Qt::LeftButton);
    EXPECT_NEAR(panel.namedPoses().poses()[0].pose.offset[2], 0.005, 1e-12)
        << "the pose replaces the old one";

    panel.setTarget(Pose{});
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Down);
    EXPECT_TRUE(panel.target()->toVector().isZero()) << "it is the last one already";
    box->showPopup();
    QTest::keyClick(box->view(), Qt::Key_Return);
    EXPECT_NEAR(panel.target()->offset[2], 0.005, 1e-12) << "chosen from the list";
}

TEST_F(TargetPanelTest, TheLampJudgesTheWayOfTheMode) {
    // The legs' own way keeps every stroke; on the straight one a leg would be too short in the middle.
    live(poseOf(-60, 60, -35, 0, 0, -21.5));
    panel.setTarget(poseOf(-17, -73, -34.5, 0, 0, -25.5));
    ASSERT_TRUE(isPlanned());
    ASSERT_TRUE(panel.check());
    EXPECT_TRUE(panel.check()->ok()) << motionCheckText(*panel.check()).toStdString();
    panel.setMode(MotionMode::Workspace);
    ASSERT_TRUE(isPlanned());
    EXPECT_EQ(panel.check()->reason, MotionCheck::Reason::LegBelowMin);
    EXPECT_LT(panel.check()->fraction, 1.0);
    EXPECT_TRUE(validity().contains(QStringLiteral("% of the path"))) << validity().toStdString();
    panel.setMode(MotionMode::Joint);
    ASSERT_TRUE(isPlanned());
    EXPECT_EQ(validity(), "Reachable");
}

class TargetPlanTest : public TargetPanelTest {
protected:
    TargetPlanTest() {
        QObject::connect(&panel, &TargetPanel::runRequested,
                         [this](const Pose& pose, MotionId, const SharedPlan& plan) {
                             targets.push_back(pose);
                             plans.push_back(plan);
                         });
        live(Pose{});
    }
    /// Without an event between the keys and what follows, so that no plan can have come.
    void typeOnly(const char* text) {
        auto* z = qobject_cast<NumberField*>(findByName(panel, QStringLiteral("Target z")));
        z->selectAll();
        QTest::keyClicks(z, QString::fromLatin1(text));
    }

    std::vector<Pose> targets;
    std::vector<SharedPlan> plans;
};

TEST_F(TargetPlanTest, RunSendsThePlanThatTheLampShows) {
    type("Target z", "20");
    button("Run")->click();
    ASSERT_EQ(plans.size(), 1U);
    ASSERT_TRUE(plans[0]);
    EXPECT_TRUE(plans[0]->check.ok());
    EXPECT_TRUE(plans[0]->isFor({targets[0], MotionMode::Joint}));
    EXPECT_NEAR(targets[0].offset.z(), 0.020, 1e-12);
    EXPECT_EQ(plans[0]->start.setPoint, geometry.homeLengths());
    button("Run")->click();
    ASSERT_EQ(plans.size(), 2U);
    EXPECT_EQ(plans[1], plans[0]) << "nothing has changed: it is not planned again";
}

TEST_F(TargetPlanTest, RunStaysDisabledUntilThePlanOfWhatIsTypedIsThere) {
    type("Target z", "20");
    ASSERT_TRUE(button("Run")->isEnabled());
    for (const char* text : {"21", "22", "23"}) {
        typeOnly(text);
        EXPECT_TRUE(panel.isPlanning());
        EXPECT_FALSE(panel.check());
        EXPECT_FALSE(button("Run")->isEnabled()) << text;
        EXPECT_EQ(button("Run")->toolTip(), "Checking the target");
        EXPECT_EQ(validity(), "Reachable") << "a check that takes no time is not shown";
        button("Run")->click();
        panel.run();
    }
    EXPECT_TRUE(targets.empty());
    ASSERT_TRUE(isPlanned());
    EXPECT_TRUE(button("Run")->isEnabled());
    EXPECT_EQ(validity(), "Reachable");
    button("Run")->click();
    ASSERT_EQ(targets.size(), 1U);
    EXPECT_NEAR(targets[0].offset.z(), 0.023, 1e-12);
    EXPECT_TRUE(plans[0]->isFor({targets[0], MotionMode::Joint}));
}

TEST_F(TargetPlanTest, APlanOfAnOlderTextIsNeverSent) {
    // Whatever arrives between the keys: Run sends nothing, or the plan of what stands there.
    for (int tenths = 0; tenths < 100; ++tenths) {
        typeOnly(QByteArray::number(tenths / 10.0).constData());
        if (tenths % 3 == 0) {
            QCoreApplication::processEvents();
        }
        const std::size_t before = targets.size();
        panel.run();
        if (targets.size() > before) {
            EXPECT_NEAR(targets.back().offset.z(), tenths * 1e-4, 1e-12);
            EXPECT_TRUE(plans.back()->isFor({targets.back(), MotionMode::Joint}));
        }
    }
    // A text that needs no plan, or has none, drops the one under way.
    for (const char* text : {"200", "-"}) {
        typeOnly("20");
        typeOnly(text);
        EXPECT_FALSE(panel.isPlanning());
        QCoreApplication::processEvents();
        EXPECT_FALSE(button("Run")->isEnabled()) << text;
    }
}

TEST_F(TargetPlanTest, ModeLimitsAndANewStartArePlannedAnew) {
    type("Target z", "20");
    panel.setMode(MotionMode::Workspace);
    EXPECT_FALSE(button("Run")->isEnabled());
    ASSERT_TRUE(isPlanned());
    Snapshot narrowed = snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, 1.1);
    narrowed.maxLength = 0.349;
    panel.showSnapshot(narrowed);
    EXPECT_FALSE(button("Run")->isEnabled());
    ASSERT_TRUE(isPlanned());
    button("Run")->click();
    ASSERT_EQ(plans.size(), 1U);
    EXPECT_EQ(plans[0]->mode(), MotionMode::Workspace);
    EXPECT_EQ(plans[0]->limits.maxLength.maxCoeff(), 0.349);
    // Where it goes from elsewhere Run stays: its text is the same, and the loop looks at the start itself.
    const Pose elsewhere = poseOf(0, 0, 3, 0, 0, 0);
    Snapshot moved = snapshotAt(geometry, elsewhere, elsewhere, RunState::Enabled, 1.2);
    moved.maxLength = narrowed.maxLength;
    ASSERT_TRUE(QTest::qWaitFor([&] {
        panel.showSnapshot(moved);
        EXPECT_TRUE(button("Run")->isEnabled());
        button("Run")->click();
        return plans.back() != plans[0];
    }));
    EXPECT_NEAR(plans.back()->start.pose.offset.z(), 0.003, 1e-9);
}

TEST_F(TargetPlanTest, NothingIsPlannedWhileSomethingMoves) {
    show(snapshotAt(geometry, Pose{}, Pose{}, RunState::Moving, 1.1));
    typeOnly("20");
    EXPECT_FALSE(panel.isPlanning());
    panel.showSnapshot(snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, 1.2));
    EXPECT_TRUE(panel.isPlanning());
    EXPECT_FALSE(button("Run")->isEnabled());
    ASSERT_TRUE(isPlanned());
    EXPECT_TRUE(button("Run")->isEnabled());
}

} // namespace
} // namespace hexapose
