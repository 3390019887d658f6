// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/events.h"
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "ui/console/motion/jog_panel.h"

#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QVBoxLayout>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace hexapose::testing;

class JogPanelTest : public ::testing::Test {
protected:
    JogPanelTest()
        : geometry(laboratoryPlatform()), panel(new JogPanel(geometry, &window, [this] { return now; })),
          elsewhere(new QLineEdit(&window)) {
        auto* column = new QVBoxLayout(&window);
        column->addWidget(panel);
        column->addWidget(elsewhere);
        QObject::connect(panel, &JogPanel::jogRequested,
                         [this](const JogDirection& direction) { jogs.push_back(direction); });
        QObject::connect(panel, &JogPanel::releaseRequested, [this] { ++releases; });
        QObject::connect(panel, &JogPanel::stepRequested,
                         [this](const Pose& pose) { steps.push_back(pose); });
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        live(RunState::Enabled);
    }
    Snapshot snapshot(RunState state) { return snapshotAt(geometry, here, here, state, 1.0); }
    void live(RunState state) {
        panel->setConnected(true);
        panel->add(snapshot(state));
        panel->showSnapshot(snapshot(state));
    }
    QPushButton* button(const char* name) {
        return qobject_cast<QPushButton*>(findByName(window, QString::fromLatin1(name)));
    }
    void choose(const char* box, int index) {
        qobject_cast<QComboBox*>(findByName(window, QString::fromLatin1(box)))->setCurrentIndex(index);
    }
    void hold(const char* name) { QTest::mousePress(button(name), Qt::LeftButton); }
    QWidget* pad() { return findByName(window, QStringLiteral("Jog keys")); }
    bool held() const { return panel->hold().direction().has_value(); }

    PlatformGeometry geometry;
    Pose here;
    JogHold::Clock::time_point now{};
    QWidget window;
    JogPanel* panel;
    QLineEdit* elsewhere;
    std::vector<JogDirection> jogs;
    std::vector<Pose> steps;
    int releases = 0;
};

TEST_F(JogPanelTest, AHeldButtonSpeaksAtOnceAndAgainUntilItIsLetGo) {
    hold("Jog -gamma");
    ASSERT_EQ(jogs.size(), 1U);
    EXPECT_EQ(jogs[0], (JogDirection{5, false, JogFrame::Base}));
    now += std::chrono::milliseconds(50);
    panel->hold().tick();
    EXPECT_EQ(jogs.size(), 2U);
    EXPECT_EQ(releases, 0);
    QTest::mouseRelease(button("Jog -gamma"), Qt::LeftButton);
    EXPECT_EQ(releases, 1);
    panel->hold().tick();
    EXPECT_EQ(jogs.size(), 2U);
    choose("Jog frame", 1);
    hold("Jog +x");
    EXPECT_EQ(jogs.back(), (JogDirection{0, true, JogFrame::Platform}));
}

TEST_F(JogPanelTest, WhateverTakesTheButtonAwayEndsIt) {
    QWidget other;
    const std::pair<const char*, std::function<void()>> ways[] = {
        {"focus", [this] { elsewhere->setFocus(); }},
        {"hidden", [this] { panel->hide(); }},
        {"another window in front",
         [&] {
             other.show();
             other.activateWindow();
             ASSERT_TRUE(QTest::qWaitForWindowActive(&other));
         }},
        {"popup",
         [this] {
             auto* menu = new QMenu(&window);
             menu->addAction(QStringLiteral("some"));
             menu->popup(window.mapToGlobal(QPoint(1, 1)));
             EXPECT_FALSE(held());
             menu->close();
         }},
        {"disconnected", [this] { panel->setConnected(false); }},
        {"stopped", [this] { live(RunState::Stopped); }},
        {"a refusal", [this] {
             Snapshot refused = snapshot(RunState::Enabled);
             refused.events.push_back(eventFrom("move-refused stale data"));
             panel->add(refused);
         }}};
    Qt::Key key = Qt::Key_Up;
    for (const auto& [name, way] : ways) {
        key = key == Qt::Key_Up ? Qt::Key_Down : Qt::Key_Up; // another one counts at once
        for (const bool byKey : {false, true}) {
            window.activateWindow();
            ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
            panel->show();
            live(RunState::Enabled);
            pad()->setFocus();
            byKey ? QTest::keyPress(pad(), key) : hold("Jog +y");
            ASSERT_TRUE(held()) << name << byKey;
            releases = 0;
            way();
            EXPECT_FALSE(held()) << name << byKey;
            EXPECT_EQ(releases, 1) << name << byKey;
            byKey ? QTest::keyRelease(pad(), key) : QTest::mouseRelease(button("Jog +y"), Qt::LeftButton);
            other.hide();
        }
    }
}

TEST_F(JogPanelTest, AScreenThatStoodStillDoesNotTakeAJogUpAgain) {
    hold("Jog +z");
    now += std::chrono::milliseconds(400);
    panel->hold().tick();
    EXPECT_EQ(jogs.size(), 1U);
    EXPECT_EQ(releases, 1);
}

TEST_F(JogPanelTest, KeysHoldWhileTheyAreDownAndRepeatsDoNotMatter) {
    pad()->setFocus();
    QTest::keyPress(pad(), Qt::Key_Right);
    ASSERT_EQ(jogs.size(), 1U);
    EXPECT_EQ(jogs[0], (JogDirection{0, true, JogFrame::Base}));
    EXPECT_TRUE(button("Jog +x")->isDown());
    for (const bool marked : {true, false}) { // a keyboard repeats by release and press, marked or not
        for (int i = 0; i < 3; ++i) {
            QKeyEvent release(QEvent::KeyRelease, Qt::Key_Right, Qt::NoModifier, {}, marked);
            QKeyEvent press(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier, {}, marked);
            QApplication::sendEvent(pad(), &release);
            QApplication::sendEvent(pad(), &press);
        }
    }
    EXPECT_EQ(jogs.size(), 1U);
    EXPECT_EQ(releases, 0);
    EXPECT_TRUE(held());
    QTest::keyRelease(pad(), Qt::Key_Right);
    ASSERT_TRUE(QTest::qWaitFor([this] { return releases == 1; }));
    EXPECT_FALSE(button("Jog +x")->isDown());
    QTest::keyPress(pad(), Qt::Key_PageDown, Qt::ShiftModifier);
    EXPECT_EQ(jogs.back(), (JogDirection{5, false, JogFrame::Base}));
    QTest::keyPress(pad(), Qt::Key_Up); // a second key makes it unclear
    EXPECT_FALSE(held());
    QTest::keyPress(pad(), Qt::Key_PageDown); // still down: that is no new press
    EXPECT_FALSE(held());
    QTest::keyPress(pad(), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_TRUE(held());
    QTest::keyRelease(pad(), Qt::Key_Shift); // alpha or x?
    EXPECT_FALSE(held());
}

TEST_F(JogPanelTest, SpaceHoldsTheButtonWithTheFocusAndOtherKeysNeedIt) {
    button("Jog -beta")->setFocus();
    QTest::keyPress(button("Jog -beta"), Qt::Key_Space);
    ASSERT_EQ(jogs.size(), 1U);
    EXPECT_EQ(jogs[0], (JogDirection{4, false, JogFrame::Base}));
    QTest::keyRelease(button("Jog -beta"), Qt::Key_Space);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !held(); }));
    elsewhere->setFocus();
    QTest::keyClick(elsewhere, Qt::Key_Right);
    EXPECT_EQ(jogs.size(), 1U) << "only with the focus on the jog buttons";
}

TEST_F(JogPanelTest, AStepIsOneMoveFromWhereItWasSent) {
    here = poseOf(1, 2, 3, 0, 0, 0);
    live(RunState::Enabled);
    choose("Jog step", 2); // 1 mm or degree
    QTest::mouseClick(button("Jog -y"), Qt::LeftButton);
    ASSERT_EQ(steps.size(), 1U);
    EXPECT_TRUE(steps[0].toVector().isApprox(poseOf(1, 1, 3, 0, 0, 0).toVector(), 1e-12));
    QTest::keyClick(pad(), Qt::Key_PageUp, Qt::ShiftModifier);
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_TRUE(steps[1].toVector().isApprox(poseOf(1, 2, 3, 0, 0, 1).toVector(), 1e-12));
    EXPECT_TRUE(jogs.empty());
    // The goal of the last move, not the noise about it; without one the measured pose.
    Snapshot off = snapshot(RunState::Enabled);
    off.measuredPose = poseOf(1.1, 2, 3, 0, 0, 0);
    panel->showSnapshot(off);
    QTest::mouseClick(button("Jog +x"), Qt::LeftButton);
    EXPECT_TRUE(steps.back().toVector().isApprox(poseOf(2, 2, 3, 0, 0, 0).toVector(), 1e-12));
    off.goalPose.reset();
    panel->showSnapshot(off);
    QTest::mouseClick(button("Jog +x"), Qt::LeftButton);
    EXPECT_TRUE(steps.back().toVector().isApprox(poseOf(2.1, 2, 3, 0, 0, 0).toVector(), 1e-12));
}

TEST_F(JogPanelTest, NothingIsAskedForWhereItWouldBeRefused) {
    for (const RunState state : {RunState::Disconnected, RunState::Unreferenced, RunState::Disabled,
                                 RunState::Stopped, RunState::Fault}) {
        live(state);
        EXPECT_FALSE(button("Jog +x")->isEnabled());
        QTest::keyPress(pad(), Qt::Key_Right);
        QTest::keyRelease(pad(), Qt::Key_Right);
    }
    live(RunState::Moving); // by something else
    hold("Jog +x");
    EXPECT_TRUE(jogs.empty());
    QTest::mouseRelease(button("Jog +x"), Qt::LeftButton);
    Snapshot jogging = snapshot(RunState::Moving);
    jogging.events.push_back({EventCode::JogStarted});
    panel->add(jogging);
    hold("Jog +x"); // of a jog that comes to rest
    EXPECT_EQ(jogs.size(), 1U);
}

} // namespace
} // namespace hexapose
