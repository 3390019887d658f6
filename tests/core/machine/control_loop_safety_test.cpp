// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// What the loop does when the machine, the controller or the link does not do what is asked.
#include "core/record/device_words.h"
#include "tests/core/machine/control_loop_fixture.h"

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing::kSettleWindow;
using testing::target;
class ControlLoopSafety : public testing::ControlLoopTest {};

// m, as the loop's defaults for the laboratory platform.
constexpr double kFollowingLimit = 0.024;
constexpr double kLongestStep = 0.0008; ///< two cycles at the leg speed

TEST_F(ControlLoopSafety, ARefusedSetPointIsExplainedByTheStateThatFollows) {
    const DeviceNotice refusal = notice::Refused{deviceRefusalFromWords("SET STATE drives are off")};
    startMoving();
    m_device.notices.push_back(refusal);
    cycles(1);
    EXPECT_EQ(m_last.state, RunState::Stopped) << "at once";
    m_device.state = ControllerState::Fault;
    m_device.ignoresStop = true; // a fault is not left by a stop
    cycles(1);
    EXPECT_EQ(detailOf(EventCode::StoppedByController), "F");
    m_device.ignoresStop = false;

    m_events.clear();
    m_loop->post(ClearCommand{});
    cycles(3);
    startMoving();
    m_device.notices.push_back(refusal);
    cycles(1);
    m_device.notices.push_back(notice::ClockWentBack{});
    m_device.link = LinkState::Connecting;
    cycles(50);
    EXPECT_TRUE(saw(EventCode::ClockWentBack));
    EXPECT_FALSE(saw(EventCode::StoppedByController)) << "it restarted";

    m_events.clear();
    m_device.link = LinkState::Connected;
    m_device.state = ControllerState::Disabled;
    cycles(3);
    startMoving();
    m_device.ignoresStop = m_device.ignoresDisable = true;
    m_device.notices.push_back(refusal);
    cycles(50);
    EXPECT_EQ(detailOf(EventCode::StoppedOnRefusal), "SET STATE drives are off") << "it stays enabled";
}

TEST_F(ControlLoopSafety, ALegThatIsHeldFastStopsAMotionLedByThePose) {
    constexpr double kFurthest = 0.012; // m, that the other legs have led the platform beside its way by then
    const Pose there = target();
    const Pose back = Pose::fromVector(-0.5 * there.toVector());
    for (int leg = 0; leg < kLegCount; ++leg) {
        SCOPED_TRACE(leg);
        m_events.clear();
        cycles(2);
        m_loop->post(RunCommand{leg % 2 == 0 ? there : back, MotionMode::Workspace});
        until(RunState::Moving);
        cycles(20);
        m_device.stuckLeg = leg;
        until(RunState::Stopped, 300);
        EXPECT_NE(detailOf(EventCode::StoppedOnFollowingError).find("leg"), std::string::npos);
        EXPECT_NE(detailOf(EventCode::StoppedOnFollowingError).find("path"), std::string::npos);
        ASSERT_TRUE(m_last.measuredPose);
        EXPECT_LT(m_last.measuredPose->offset.norm(), there.offset.norm() + kFurthest);
        m_device.stuckLeg.reset();
        cycles(2);
        m_loop->post(ClearCommand{});
        cycles(3);
    }
}

TEST_F(ControlLoopSafety, AStopEndsTheWaitItIsPostedDuringAndLeavesInTheSameCycle) {
    startMoving();
    int forSpeed = -1, forStop = -1;
    m_device.during = [&] {
        m_loop->post(SpeedCommand{0.5});
        forSpeed = m_device.interruptions;
        m_loop->post(StopCommand{});
        forStop = m_device.interruptions;
    };
    cycles(1);
    m_device.during = {};
    EXPECT_EQ(forSpeed, 0) << "only a stop does";
    EXPECT_EQ(forStop, 1);
    EXPECT_EQ(m_device.received.back().request, DeviceRequest::Stop);
}

TEST_F(ControlLoopSafety, NothingIsSentToAControllerThatIsEnabledAlreadyUntilTheOperatorActs) {
    m_device.state = ControllerState::Enabled;
    cycles(50);
    EXPECT_FALSE(anySetPointSince(0));
    EXPECT_EQ(m_last.state, RunState::Enabled);
    m_loop->post(EnableCommand{});
    cycles(5);
    EXPECT_EQ(requestsSince(0), std::vector{DeviceRequest::Enable});
    EXPECT_TRUE(anySetPointSince(0)) << "held from here on";

    m_device.link = LinkState::Lost;
    cycles(5);
    m_device.link = LinkState::Connected;
    const std::size_t mark = m_device.received.size();
    cycles(50);
    EXPECT_FALSE(anySetPointSince(mark));
    EXPECT_TRUE(requestsSince(mark).empty()) << "nothing moved when it was lost";
    EXPECT_FALSE(saw(EventCode::StoppedByController));
    EXPECT_FALSE(saw(EventCode::StoppedAfterLoss));
    run();
    until(RunState::Moving);
    until(RunState::Enabled);
}

TEST_F(ControlLoopSafety, ClearEndsAStopThatTheControllerHasNoStateFor) {
    m_device.stopsOnlyWhenEnabled = true;
    m_device.state = ControllerState::Disabled;
    cycles(2);
    m_loop->post(StopCommand{});
    cycles(5);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    m_loop->post(ClearCommand{});
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Disabled);
    EXPECT_TRUE(saw(EventCode::Cleared));
}

TEST_F(ControlLoopSafety, ALegThatDoesNotFollowStopsTheMoveAndIsNamed) {
    startMoving();
    m_device.stuck = true;
    const std::size_t mark = m_device.received.size();
    until(RunState::Stopped);
    const std::string detail = detailOf(EventCode::StoppedOnFollowingError);
    EXPECT_EQ(detail.rfind("leg ", 0), 0u) << detail;
    EXPECT_NE(detail.find("limit 24.0 mm"), std::string::npos) << detail;
    EXPECT_EQ(m_device.received.back().request, DeviceRequest::Stop) << "in the cycle that measured it";
    const LegLengths gap = m_device.received[m_device.received.size() - 2].lengths.value() - m_device.lengths;
    EXPECT_LT(gap.cwiseAbs().maxCoeff(), kFollowingLimit + kLongestStep) << "stopped at once";
    EXPECT_GT(m_device.received.size(), mark + 10) << "an ordinary lag is no cause";
}

TEST_F(ControlLoopSafety, AControllerThatTakesNoSetPointsStopsTheMove) {
    startMoving();
    m_device.deaf = true;
    const std::size_t mark = m_device.received.size();
    until(RunState::Stopped, 60);
    EXPECT_TRUE(saw(EventCode::StoppedOnNoEcho));
    EXPECT_GE(m_device.received.size(), mark + 30) << "300 ms of 10 ms cycles";
    EXPECT_EQ(m_device.received.back().request, DeviceRequest::Stop);
    cycles(1);
    EXPECT_EQ(m_device.received.back().request, DeviceRequest::Disable);
}

TEST_F(ControlLoopSafety, NoSetPointBeyondAStrokeGoesOut) {
    startMoving();
    m_device.minLength = 0.250; // told before, and then narrowed below what the path has reached
    m_device.maxLength = 0.301;
    const std::size_t mark = m_device.received.size();
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_EQ(requestsSince(mark), (std::vector{DeviceRequest::Stop, DeviceRequest::Disable}));
    EXPECT_EQ(detailOf(EventCode::StoppedOnNewIdentity), ", 250 to 301 mm");
}

TEST_F(ControlLoopSafety, AHeldPlatformBeyondItsStrokesIsStoppedBeforeASetPointGoesOut) {
    constexpr double kBeyond = 0.001; // m, no noise
    for (const double beyond : {kBeyond, 0.5 * kSettleWindow}) {
        SCOPED_TRACE(beyond);
        m_events.clear();
        m_device.state = ControllerState::Disabled;
        m_device.lengths = m_geometry.homeLengths();
        m_device.lengths[2] = m_geometry.legs[2].minLength - beyond;
        cycles(2);
        const std::size_t mark = m_device.received.size();
        m_loop->post(EnableCommand{});
        cycles(5);
        EXPECT_EQ(detailOf(EventCode::StoppedOnLimits),
                  beyond == kBeyond ? "leg 3 below min_mm" : "no such event");
        for (std::size_t k = mark; k < m_device.received.size(); ++k) {
            const auto& sent = m_device.received[k].lengths;
            EXPECT_TRUE(!sent || (*sent)[2] >= m_geometry.legs[2].minLength);
        }
        m_loop->post(ClearCommand{});
        cycles(2);
    }
}

TEST_F(ControlLoopSafety, AnotherControllerInMidMoveStopsIt) {
    startMoving();
    m_device.name = "Other";
    const std::size_t mark = m_device.received.size();
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_EQ(requestsSince(mark), (std::vector{DeviceRequest::Stop, DeviceRequest::Disable}));
    EXPECT_EQ(detailOf(EventCode::StoppedOnNewIdentity), "Other");
}

/// The first set-point after the mark is the one of the late cycle.
TEST_F(ControlLoopSafety, AHostThatStoodStillGoesOnWithoutALeap) {
    constexpr double kLegSpeed = 0.04;     // m/s, a stroke in 2.5 s
    constexpr double kLongestCycle = 0.03; // s of the path
    constexpr double kRoundOff = 1.001;
    for (const MotionMode mode : {MotionMode::Joint, MotionMode::Workspace}) {
        SCOPED_TRACE(toWord(mode));
        rebuild({});
        cycles(2);
        m_loop->post(RunCommand{target(), mode});
        until(RunState::Moving);
        cycles(60);
        const std::size_t mark = m_device.received.size();
        m_device.late = 200ms;
        until(RunState::Enabled);
        for (std::size_t k = mark; k < m_device.received.size(); ++k) {
            const LegLengths step = *m_device.received[k].lengths - *m_device.received[k - 1].lengths;
            EXPECT_LE(step.cwiseAbs().maxCoeff(), kRoundOff * kLegSpeed * kLongestCycle) << k - mark;
        }
        m_loop->post(RunCommand{Pose{}}); // back: both modes take the same path
        until(RunState::Moving);
        until(RunState::Enabled);
    }
}

TEST_F(ControlLoopSafety, AProtocolWithoutAnEchoIsJudgedByTheLegsAlone) {
    m_device.echoes = false;
    startMoving();
    until(RunState::Enabled);
    EXPECT_TRUE(saw(EventCode::Settled));
    cycles(100);
    EXPECT_EQ(m_last.state, RunState::Enabled);
}

TEST_F(ControlLoopSafety, AsksToReferenceAgainAndGivesUpSoonWhenNothingAnswers) {
    m_device.ignoresReference = true;
    cycles(2);
    run();
    cycles(2);
    const DeviceNotice unanswered = notice::NoAnswer{DeviceRequest::Reference};
    for (int asked = 1; asked <= 3; ++asked) {
        EXPECT_EQ(requestsSince(0), std::vector(static_cast<std::size_t>(asked), DeviceRequest::Reference));
        EXPECT_FALSE(saw(EventCode::PreparationFailed));
        m_device.notices.push_back(unanswered);
        cycles(2);
    }
    EXPECT_EQ(requestsSince(0).size(), 3U);
    EXPECT_EQ(detailOf(EventCode::PreparationFailed), "HOME was not answered");
    EXPECT_EQ(m_last.state, RunState::Unreferenced);
}

TEST_F(ControlLoopSafety, AReferencingWhoseAnswerWasLostIsNotAskedForAgainOnceItIsDone) {
    cycles(2);
    run();
    until(RunState::Moving); // the state came, the answer never did
    const std::size_t mark = m_device.received.size();
    m_device.notices.push_back(notice::NoAnswer{DeviceRequest::Reference});
    cycles(2);
    m_device.notices.push_back(notice::Refused{deviceRefusalFromWords("HOME STATE not allowed in state E")});
    until(RunState::Enabled);
    EXPECT_TRUE(requestsSince(mark).empty());
    EXPECT_TRUE(saw(EventCode::Settled));
    EXPECT_FALSE(saw(EventCode::PreparationFailed));
}

TEST_F(ControlLoopSafety, AReferencingThatWasTakenMayLast) {
    m_device.ignoresReference = true;
    cycles(2);
    run();
    cycles(2);
    m_device.notices.push_back(notice::NoAnswer{DeviceRequest::Reference});
    cycles(2);
    m_device.notices.push_back(notice::Acknowledged{DeviceRequest::Reference});
    cycles(2);
    m_device.notices.push_back(notice::Refused{deviceRefusalFromWords("HOME STATE it is at it")});
    m_device.notices.push_back(notice::NoAnswer{DeviceRequest::Reference});
    cycles(6000);
    EXPECT_EQ(requestsSince(0).size(), 2U);
    EXPECT_FALSE(saw(EventCode::PreparationFailed));
    m_device.state = ControllerState::Disabled;
    until(RunState::Enabled);
}

} // namespace
} // namespace hexapose
