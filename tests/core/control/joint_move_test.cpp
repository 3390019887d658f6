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
    EXPECT_FALSE(move.setPoint(m_start + 30ms)) << "nothing moves before start()";
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
    move.update(ControllerState::Enabled, m_here, kWindow, now);
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

TEST_F(JointMoveTest, SaysOnceThatItHasNotSettledAndGoesOnWaiting) {
    JointMove move = begin(ControllerState::Enabled);
    move.start(m_here, 0.04, m_start);
    auto now = m_start + move.duration();
    move.update(ControllerState::Enabled, m_here, kWindow, now);
    EXPECT_EQ(move.update(ControllerState::Enabled, m_here, kWindow, now += 2001ms)->code,
              EventCode::NotSettled);
    EXPECT_FALSE(move.update(ControllerState::Enabled, m_here, kWindow, now += 5s));
    EXPECT_EQ(move.phase(), Phase::Settling);
}

} // namespace
} // namespace hexapose
