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
        : geometry(laboratoryPlatform()),
          panel(new JogPanel(makeModel(geometry), &window, [this] { return now; })),
          elsewhere(new QLineEdit(&window)) {
        auto* column = new QVBoxLayout(&window);
        column->addWidget(panel);
        column->addWidget(elsewhere);
        QObject::connect(panel, &JogPanel::jogRequested, [this](const JogDirection& direction, MotionId id) {
            jogs.push_back(direction);
            jogId = id;
        });
        QObject::connect(panel, &JogPanel::releaseRequested, [this] { ++releases; });
        QObject::connect(panel, &JogPanel::stepRequested, [this](const Pose& pose, MotionId id) {
            steps.push_back(pose);
            stepId = id;
        });
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
    void stepTaken() {
        panel->add(moving(stepId));
        live(RunState::Enabled);
    }
    Snapshot moving(MotionId id) {
        Snapshot moving = snapshot(RunState::Moving);
        moving.motionId = id;
        return moving;
    }
    bool allUp() {
        return QTest::qWaitFor([this] { return panel->isAllUp(); });
    }
    /// What the keyboard makes of a held key: a release and a press, marked or not.
    void repeat(Qt::Key key, bool marked) {
        for (const QEvent::Type type : {QEvent::KeyRelease, QEvent::KeyPress}) {
            QKeyEvent event(type, key, Qt::NoModifier, {}, marked);
            QApplication::sendEvent(pad(), &event);
        }
    }
    /// The pointer, with the left button down.
    void dragTo(QPushButton& over, const QPoint& at) {
        QMouseEvent move(QEvent::MouseMove, at, over.mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(&over, &move);
    }
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
    MotionId jogId = kNoMotion;
    MotionId stepId = kNoMotion;
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
            ASSERT_TRUE(allUp());
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
    QTest::keyRelease(pad(), Qt::Key_PageDown);
    QTest::keyRelease(pad(), Qt::Key_Up);
    ASSERT_TRUE(allUp());
    QTest::keyPress(pad(), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_TRUE(held());
    QTest::keyRelease(pad(), Qt::Key_Shift); // alpha or x?
    EXPECT_FALSE(held());
}

TEST_F(JogPanelTest, ASecondKeyEndsItAndNothingStartsBeforeAllAreUp) {
    pad()->setFocus();
    QTest::keyPress(pad(), Qt::Key_Down);
    ASSERT_TRUE(held());
    QTest::keyPress(pad(), Qt::Key_Right);
    EXPECT_FALSE(held());
    for (const bool marked : {true, false}) {
        for (const Qt::Key key : {Qt::Key_Right, Qt::Key_Down, Qt::Key_Right}) {
            repeat(key, marked);
            EXPECT_FALSE(held()) << key << marked;
        }
    }
    QTest::keyRelease(pad(), Qt::Key_Right);
    QTest::keyPress(pad(), Qt::Key_Up); // a third one
    repeat(Qt::Key_Down, false);
    EXPECT_FALSE(held());
    EXPECT_EQ(jogs.size(), 1U);
    EXPECT_EQ(releases, 1);
    QTest::keyRelease(pad(), Qt::Key_Up);
    QTest::keyRelease(pad(), Qt::Key_Down);
    ASSERT_TRUE(allUp());
    QTest::keyPress(pad(), Qt::Key_Right);
    EXPECT_TRUE(held());
}

TEST_F(JogPanelTest, AKeyAndAButtonAreTwoAsWell) {
    pad()->setFocus();
    QTest::keyPress(pad(), Qt::Key_Down);
    ASSERT_TRUE(held());
    hold("Jog +x"); // which takes the focus from the pad to itself
    EXPECT_FALSE(held());
    QTest::mouseRelease(button("Jog +x"), Qt::LeftButton);
    hold("Jog +x");
    EXPECT_FALSE(held()) << "the key is still down";
    QTest::keyRelease(button("Jog +x"), Qt::Key_Down);
    QTest::mouseRelease(button("Jog +x"), Qt::LeftButton);
    ASSERT_TRUE(allUp());
    hold("Jog +x");
    ASSERT_TRUE(held());
    QTest::keyPress(button("Jog +x"), Qt::Key_Down);
    EXPECT_FALSE(held());
    QTest::keyRelease(button("Jog +x"), Qt::Key_Down);
    ASSERT_FALSE(QTest::qWaitFor([this] { return panel->isAllUp(); }, 50)) << "the button is still down";
    QTest::keyPress(button("Jog +x"), Qt::Key_Down);
    EXPECT_FALSE(held());
    EXPECT_EQ(jogs.size(), 2U);
}

TEST_F(JogPanelTest, AKeyHeldThroughAChangeOfTheFocusStartsNothing) {
    pad()->setFocus();
    QTest::keyPress(pad(), Qt::Key_Up);
    elsewhere->setFocus();
    EXPECT_FALSE(held());
    pad()->setFocus();
    for (const bool marked : {true, false}) {
        repeat(Qt::Key_Up, marked);
        EXPECT_FALSE(held()) << marked;
    }
    QTest::keyRelease(pad(), Qt::Key_Up);
    ASSERT_TRUE(allUp());
    QTest::keyPress(pad(), Qt::Key_Up);
    EXPECT_TRUE(held());
}

TEST_F(JogPanelTest, ThePointerThatComesBackToAHeldButtonStartsNothing) {
    QPushButton& down = *button("Jog +x");
    hold("Jog +x");
    ASSERT_TRUE(held());
    for (int i = 0; i < 2; ++i) {
        dragTo(down, QPoint(-30, -30));
        EXPECT_FALSE(held());
        dragTo(down, down.rect().center());
        EXPECT_TRUE(down.isDown()) << "Qt presses it again";
        EXPECT_FALSE(held());
    }
    QTest::mouseRelease(&down, Qt::LeftButton);
    EXPECT_EQ(jogs.size(), 1U);
    hold("Jog +x");
    EXPECT_TRUE(held()) << "a new press";
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
    stepTaken();
    EXPECT_TRUE(steps[0].toVector().isApprox(poseOf(1, 1, 3, 0, 0, 0).toVector(), 1e-12));
    QTest::keyClick(pad(), Qt::Key_PageUp, Qt::ShiftModifier);
    ASSERT_EQ(steps.size(), 2U);
    stepTaken();
    ASSERT_TRUE(allUp());
    EXPECT_TRUE(steps[1].toVector().isApprox(poseOf(1, 2, 3, 0, 0, 1).toVector(), 1e-12));
    EXPECT_TRUE(jogs.empty());
    // The goal of the last move, not the noise about it; without one the measured pose.
    Snapshot off = snapshot(RunState::Enabled);
    off.measuredPose = poseOf(1.1, 2, 3, 0, 0, 0);
    panel->showSnapshot(off);
    QTest::mouseClick(button("Jog +x"), Qt::LeftButton);
    EXPECT_TRUE(steps.back().toVector().isApprox(poseOf(2, 2, 3, 0, 0, 0).toVector(), 1e-12));
    stepTaken();
    off.goalPose.reset();
    panel->showSnapshot(off);
    QTest::mouseClick(button("Jog +x"), Qt::LeftButton);
    EXPECT_TRUE(steps.back().toVector().isApprox(poseOf(2.1, 2, 3, 0, 0, 0).toVector(), 1e-12));
}

TEST_F(JogPanelTest, AStepThatCannotBeTakenIsSaidToBeNone) {
    const auto hint = [this] { return spokenText(window, QStringLiteral("Jog hint")); };
    choose("Jog step", 2);
    QTest::mouseClick(button("Jog +x"), Qt::LeftButton);
    ASSERT_EQ(steps.size(), 1U);
    QTest::mouseClick(button("Jog +x"), Qt::LeftButton); // before the loop has answered
    EXPECT_EQ(steps.size(), 1U);
    EXPECT_TRUE(hint().contains(QStringLiteral("was not taken"))) << hint().toStdString();
    panel->add(moving(stepId));
    panel->showSnapshot(moving(stepId));
    EXPECT_TRUE(button("Jog +x")->isEnabled());
    QTest::mouseClick(button("Jog +x"), Qt::LeftButton);
    EXPECT_EQ(steps.size(), 1U);
    EXPECT_TRUE(hint().contains(QStringLiteral("was not taken")));
    live(RunState::Settling);
    QTest::mouseClick(button("Jog +x"), Qt::LeftButton);
    EXPECT_EQ(steps.size(), 2U);
    EXPECT_FALSE(hint().contains(QStringLiteral("was not taken")));
    Snapshot refused = snapshot(RunState::Enabled);
    refused.events.push_back(eventFrom("move-refused leg 3 above max_mm"));
    panel->add(refused);
    QTest::mouseClick(button("Jog -x"), Qt::LeftButton);
    EXPECT_EQ(steps.size(), 3U) << "after a refusal the next one counts";
}

TEST_F(JogPanelTest, NothingIsAskedForWhereItWouldBeRefused) {
    for (const RunState state : {RunState::Disconnected, RunState::Unreferenced, RunState::Disabled,
                                 RunState::Stopped, RunState::Fault}) {
        live(state);
        EXPECT_FALSE(button("Jog +x")->isEnabled());
        QTest::keyPress(pad(), Qt::Key_Right);
        QTest::keyRelease(pad(), Qt::Key_Right);
    }
    ASSERT_TRUE(allUp());
    live(RunState::Moving); // by something else
    EXPECT_FALSE(button("Jog +x")->isEnabled());
    EXPECT_TRUE(spokenText(window, QStringLiteral("Jog hint")).contains(QStringLiteral("Wait until")));
    hold("Jog +x");
    EXPECT_TRUE(jogs.empty());
    QTest::mouseRelease(button("Jog +x"), Qt::LeftButton);
}

/// The loop gives a motion to one press alone; the next waits for its end, as long as it is held.
TEST_F(JogPanelTest, APressWhileAJogComesToRestStartsTheNextOne) {
    hold("Jog +x");
    const MotionId first = jogId;
    panel->add(moving(first));
    panel->showSnapshot(moving(first));
    QTest::mouseRelease(button("Jog +x"), Qt::LeftButton);
    EXPECT_TRUE(button("Jog -x")->isEnabled());
    hold("Jog -x");
    EXPECT_TRUE(held());
    panel->hold().tick();
    EXPECT_EQ(jogs.size(), 1U) << "the first still moves";
    live(RunState::Settling);
    panel->hold().tick();
    ASSERT_EQ(jogs.size(), 2U);
    EXPECT_EQ(jogs[1], (JogDirection{0, false, JogFrame::Base}));
    EXPECT_NE(jogId, first);
    panel->add(moving(jogId));
    panel->showSnapshot(moving(jogId));
    panel->hold().tick();
    EXPECT_EQ(jogs.size(), 3U) << "and is repeated in its own motion";
}

} // namespace
} // namespace hexapose
