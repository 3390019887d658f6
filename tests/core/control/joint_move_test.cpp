// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/control/joint_move.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using Phase = JointMove::Phase;

constexpr JointMove::Timing kTiming{300ms, 2s, 1s, 5s};
constexpr double kWindow = 2e-4;

class JointMoveTest : public ::testing::Test {
protected:
    void stepToTheEnd(JointMove& move, JointMove::Clock::time_point now) {
        move.step(now, move.duration());
        move.update(ControllerState::Enabled, m_here, kWindow, now);
    }
    JointMove begin(ControllerState state) { return {Pose{}, m_there, state, kTiming, m_start}; }
    LegLengths m_here = LegLengths::Constant(0.30);
    LegLengths m_there = LegLengths::Constant(0.32);
    JointMove::Clock::time_point m_start{1h};
};

TEST_F(JointMoveTest, ReferencesThenEnablesThenIsReady) {
    JointMove move = begin(ControllerState::Unreferenced);
    EXPECT_EQ(move.takeRequest(), DeviceRequest::Reference);
    EXPECT_EQ(move.takeRequest(), DeviceRequest::None) << "asked for once";
    EXPECT_FALSE(move.update(ControllerState::Unreferenced, m_here, kWindow, m_start + 10ms));
    EXPECT_EQ(move.update(ControllerState::Disabled, m_here, kWindow, m_start + 20ms)->code,
              EventCode::Referenced);
    EXPECT_EQ(move.takeRequest(), DeviceRequest::Enable);
    EXPECT_EQ(move.update(ControllerState::Enabled, m_here, kWindow, m_start + 30ms)->code,
              EventCode::Enabled);
    EXPECT_EQ(move.phase(), Phase::Ready);
    EXPECT_FALSE(move.setPoint()) << "nothing moves before start()";
}

TEST_F(JointMoveTest, GivesUpWhenThePreparationDoesNotCome) {
    JointMove unreferenced = begin(ControllerState::Unreferenced);
    EXPECT_FALSE(unreferenced.update(ControllerState::Unreferenced, m_here, kWindow, m_start + 4999ms));
    EXPECT_EQ(unreferenced.update(ControllerState::Unreferenced, m_here, kWindow, m_start + 5001ms)->detail,
              "reference");
    EXPECT_EQ(unreferenced.phase(), Phase::Failed);
    JointMove disabled = begin(ControllerState::Disabled);
    EXPECT_EQ(disabled.update(ControllerState::Disabled, m_here, kWindow, m_start + 1001ms)->detail,
              "enable");
}

TEST_F(JointMoveTest, SettlesOnlyAfterTheWholeTimeInsideTheWindow) {
    JointMove move = begin(ControllerState::Enabled);
    move.start(m_here, 0.04, m_start);
    auto now = m_start + move.duration();
    stepToTheEnd(move, now);
    ASSERT_EQ(move.phase(), Phase::Settling);
    move.update(ControllerState::Enabled, m_there, kWindow, now += 10ms);
    EXPECT_FALSE(move.update(ControllerState::Enabled, m_there, kWindow, now += 290ms));
    const LegLengths out = m_there.array() + 1.5 * kWindow;
    EXPECT_FALSE(move.update(ControllerState::Enabled, out, kWindow, now += 10ms))
        << "leaving the window starts anew";
    move.update(ControllerState::Enabled, m_there, kWindow, now += 10ms);
    EXPECT_FALSE(move.update(ControllerState::Enabled, std::nullopt, kWindow, now += 300ms))
        << "needs a measurement";
    EXPECT_EQ(move.update(ControllerState::Enabled, m_there, kWindow, now += 10ms)->code, EventCode::Settled);
    EXPECT_EQ(move.phase(), Phase::Settled);
}

TEST_F(JointMoveTest, ALateCycleSlowsThePathAndMakesNoLeap) {
    constexpr auto kMostOfCycle = 30ms;
    constexpr double kLegSpeed = 0.04;
    JointMove move = begin(ControllerState::Enabled);
    move.start(m_here, kLegSpeed, m_start);
    auto now = m_start;
    LegLengths last = m_here;
    for (int cycle = 0; move.phase() == Phase::Moving && cycle < 1000; ++cycle) {
        now += cycle == 40 ? 2000ms : 10ms;
        move.step(now, kMostOfCycle);
        move.update(ControllerState::Enabled, m_here, kWindow, now);
        const LegLengths next = move.setPoint().value();
        EXPECT_LE((next - last).cwiseAbs().maxCoeff(), 1.001 * kLegSpeed * 0.030) << cycle;
        last = next;
    }
    EXPECT_EQ(last, m_there);
    EXPECT_EQ(move.phase(), Phase::Settling);
    EXPECT_GT(now - m_start, move.duration() + 1900ms);
}

TEST_F(JointMoveTest, SaysOnceThatItHasNotSettledAndGoesOnWaiting) {
    JointMove move = begin(ControllerState::Enabled);
    move.start(m_here, 0.04, m_start);
    auto now = m_start + move.duration();
    stepToTheEnd(move, now);
    EXPECT_EQ(move.update(ControllerState::Enabled, m_here, kWindow, now += 2001ms)->code,
              EventCode::NotSettled);
    EXPECT_FALSE(move.update(ControllerState::Enabled, m_here, kWindow, now += 5s));
    EXPECT_EQ(move.phase(), Phase::Settling);
}

} // namespace
} // namespace hexapose
