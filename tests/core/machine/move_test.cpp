// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/move.h"

#include "core/record/event_codec.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using Phase = Move::Phase;

constexpr Move::Timing kTiming{300ms, 2s, 1s, 5s};

class MoveTest : public ::testing::Test {
protected:
    Move made(ControllerState state) { return {state, kTiming, m_start}; }
    /// A move whose path is just over.
    Move atTheEnd(Move::Clock::time_point now) {
        Move move = made(ControllerState::Enabled);
        move.begin(m_start);
        move.update(ControllerState::Enabled, true, false, now);
        return move;
    }
    Move::Clock::time_point m_start{1h};
};

TEST_F(MoveTest, ReferencesThenEnablesThenIsReady) {
    Move move = made(ControllerState::Unreferenced);
    EXPECT_EQ(move.nextRequest(), DeviceRequest::Reference);
    EXPECT_EQ(move.nextRequest(), DeviceRequest::None) << "asked for once";
    EXPECT_FALSE(move.update(ControllerState::Unreferenced, false, {}, m_start + 10ms));
    EXPECT_EQ(move.update(ControllerState::Disabled, false, {}, m_start + 20ms)->code, EventCode::Referenced);
    EXPECT_EQ(move.nextRequest(), DeviceRequest::Enable);
    EXPECT_EQ(move.update(ControllerState::Enabled, false, {}, m_start + 30ms)->code, EventCode::Enabled);
    EXPECT_EQ(move.phase(), Phase::Ready);
    EXPECT_FALSE(move.update(ControllerState::Enabled, true, true, m_start + 40ms));
    EXPECT_EQ(move.phase(), Phase::Ready) << "nothing moves before begin()";
}

TEST_F(MoveTest, GivesUpWhenThePreparationDoesNotCome) {
    Move unreferenced = made(ControllerState::Unreferenced);
    EXPECT_FALSE(unreferenced.update(ControllerState::Unreferenced, false, {}, m_start + 4999ms));
    EXPECT_EQ(payloadWords(*unreferenced.update(ControllerState::Unreferenced, false, {}, m_start + 5001ms)),
              "reference");
    EXPECT_EQ(unreferenced.phase(), Phase::Failed);
    Move disabled = made(ControllerState::Disabled);
    EXPECT_EQ(payloadWords(*disabled.update(ControllerState::Disabled, false, {}, m_start + 1001ms)),
              "enable");
}

TEST_F(MoveTest, SettlesOnlyAfterTheWholeTimeInsideTheWindow) {
    auto now = m_start + 2s;
    Move move = atTheEnd(now);
    ASSERT_EQ(move.phase(), Phase::Settling);
    move.update(ControllerState::Enabled, true, true, now += 10ms);
    EXPECT_FALSE(move.update(ControllerState::Enabled, true, true, now += 290ms));
    EXPECT_FALSE(move.update(ControllerState::Enabled, true, false, now += 10ms))
        << "leaving the window starts anew";
    EXPECT_FALSE(move.update(ControllerState::Enabled, true, true, now += 10ms))
        << "what was inside before it does not count";
    EXPECT_FALSE(move.update(ControllerState::Enabled, true, {}, now += 300ms)) << "needs a measurement";
    ASSERT_EQ(move.phase(), Phase::Settling);
    EXPECT_EQ(move.update(ControllerState::Enabled, true, true, now += 10ms)->code, EventCode::Settled);
    EXPECT_EQ(move.phase(), Phase::Settled);
}

TEST_F(MoveTest, SaysOnceThatItHasNotSettledAndGoesOnWaiting) {
    auto now = m_start + 1s;
    Move move = atTheEnd(now);
    EXPECT_EQ(move.update(ControllerState::Enabled, true, false, now += 2001ms)->code, EventCode::NotSettled);
    EXPECT_FALSE(move.update(ControllerState::Enabled, true, false, now += 5s));
    EXPECT_EQ(move.phase(), Phase::Settling);
}

} // namespace
} // namespace hexapose
