// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/device_words.h"
#include "tests/core/machine/control_loop_fixture.h"

#include <limits>
#include <thread>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing::ControlLoopTest;
using testing::kSettleWindow;
using testing::target;

TEST_F(ControlLoopTest, RunReferencesEnablesMovesAndSettlesOnTheTarget) {
    cycles(3);
    EXPECT_EQ(m_last.state, RunState::Unreferenced);
    run();
    until(RunState::Settling);
    until(RunState::Enabled);
    const std::vector<EventCode> order{EventCode::Referencing, EventCode::Referenced, EventCode::Enabled,
                                       EventCode::MoveStarted, EventCode::Settled};
    auto from = m_events.begin();
    for (const EventCode code : order) {
        from = std::find_if(from, m_events.end(), [&](const Event& e) { return e.code == code; });
        EXPECT_NE(from, m_events.end()) << toWord(code);
    }
    ASSERT_TRUE(m_last.measuredPose);
    EXPECT_LT((m_last.measuredPose->offset - target().offset).norm(), kSettleWindow);
    EXPECT_NEAR(m_last.measuredPose->angles.gamma, target().angles.gamma, radiansFromDeg(0.05));
    ASSERT_TRUE(m_last.targetPose);
    EXPECT_LT((m_last.targetPose->toVector() - target().toVector()).norm(), 1e-9);
    EXPECT_EQ(m_last.status, SolveStatus::Converged);
}

TEST_F(ControlLoopTest, NothingButRunStartsMotion) {
    cycles(3);
    const std::size_t mark = m_device.received.size();
    m_loop->post(ReferenceCommand{});
    cycles(5);
    m_loop->post(EnableCommand{});
    cycles(50);
    EXPECT_EQ(m_last.state, RunState::Enabled);
    m_loop->post(StopCommand{});
    cycles(5);
    m_loop->post(ClearCommand{});
    cycles(5);
    m_loop->post(EnableCommand{});
    cycles(50);
    EXPECT_FALSE(motionWasSentSince(mark)) << "held set-points may be sent, moving ones not";
    EXPECT_FALSE(saw(EventCode::MoveStarted));
}

TEST_F(ControlLoopTest, StopGoesOutInTheNextExchangeBeatsWhatIsQueuedAndNeedsClear) {
    startMoving();
    const std::size_t mark = m_device.received.size();
    run();
    m_loop->post(StopCommand{});
    run();
    cycles(1);
    EXPECT_EQ(m_device.received[mark].request, DeviceRequest::Stop);
    EXPECT_FALSE(m_device.received[mark].lengths);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_FALSE(m_last.goalPose) << "after a stop the target is where the platform is";
    run();
    cycles(50);
    EXPECT_EQ(detailOf(EventCode::CommandRefused), "run in stopped");
    for (std::size_t k = mark; k < m_device.received.size(); ++k)
        EXPECT_FALSE(m_device.received[k].lengths);
    m_loop->post(ClearCommand{});
    cycles(5);
    EXPECT_EQ(m_last.state, RunState::Disabled);
    run();
    until(RunState::Moving);
    until(RunState::Enabled);
}

TEST_F(ControlLoopTest, RefusesAnUnreachableTargetWholeWithTheReason) {
    cycles(2);
    Pose high = target();
    high.offset.z() = 0.09;
    m_loop->post(RunCommand{high});
    cycles(20);
    EXPECT_NE(detailOf(EventCode::MoveRefused).find("above max_mm"), std::string::npos);
    EXPECT_EQ(m_device.state, ControllerState::Unreferenced) << "a refused move does not even reference";
    Pose bad;
    bad.angles.beta = std::numeric_limits<double>::quiet_NaN();
    m_events.clear();
    m_loop->post(RunCommand{bad});
    cycles(2);
    EXPECT_EQ(detailOf(EventCode::MoveRefused), "invalid-input");
}

TEST_F(ControlLoopTest, TheControllersOwnLimitsCountToo) {
    m_device.maxLength = 0.330;
    cycles(2);
    run();
    cycles(2);
    EXPECT_NE(detailOf(EventCode::MoveRefused).find("above max_mm"), std::string::npos);
}

TEST_F(ControlLoopTest, SilenceWhileMovingStopsAndShowsStaleData) {
    startMoving();
    m_device.silent = true;
    until(RunState::Stopped, 60);
    EXPECT_TRUE(m_last.stale);
    EXPECT_TRUE(saw(EventCode::DataStale));
    EXPECT_TRUE(saw(EventCode::StoppedOnStaleData));
    cycles(1000);
    EXPECT_GT(m_last.age, 9s);
    m_device.silent = false;
    cycles(3);
    EXPECT_FALSE(m_last.stale);
    EXPECT_EQ(m_last.state, RunState::Stopped) << "data that comes back starts nothing";
}

TEST_F(ControlLoopTest, ABadMeasurementStopsAndNeverBecomesAPose) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -0.3, 0.0, 5.0}) {
        SCOPED_TRACE(bad);
        m_device.state = ControllerState::Enabled;
        m_device.reportInstead.reset();
        startMoving();
        LegLengths broken = m_device.lengths;
        broken[3] = bad;
        m_device.reportInstead = broken;
        cycles(1);
        EXPECT_FALSE(m_last.measuredPose);
        EXPECT_EQ(m_last.state, RunState::Stopped);
        EXPECT_TRUE(saw(EventCode::StoppedOnSolver));
        m_device.reportInstead.reset();
        cycles(2);
        m_loop->post(ClearCommand{});
        cycles(3);
        m_device.lengths = m_geometry.homeLengths();
    }
}

TEST_F(ControlLoopTest, AControllerThatStopsFaultsOrRefusesEndsTheMove) {
    startMoving();
    m_device.state = ControllerState::Stopped;
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_EQ(detailOf(EventCode::StoppedByController), "S");
    m_loop->post(ClearCommand{});
    cycles(2);

    startMoving();
    m_device.notices.push_back(notice::Fault{"7 leg 2 overcurrent"});
    m_device.state = ControllerState::Fault;
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Fault);
    EXPECT_EQ(detailOf(EventCode::ControllerFault), "7 leg 2 overcurrent");
    m_loop->post(ClearCommand{});
    cycles(2);

    startMoving();
    m_device.notices.push_back(notice::Refused{deviceRefusalFromWords("SET RANGE leg 1")});
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_EQ(detailOf(EventCode::StoppedOnRefusal), "SET RANGE leg 1");
}

TEST_F(ControlLoopTest, ALostPortShowsNothingAsLiveAndComesBackAtRest) {
    startMoving();
    m_device.link = LinkState::Lost;
    m_device.notices.push_back(notice::LinkLost{{PortFailure::Kind::Other, {}, "unplugged"}});
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Disconnected);
    EXPECT_TRUE(m_last.stale);
    EXPECT_FALSE(m_last.commandedLengths);
    m_device.link = LinkState::Connected;
    const std::size_t mark = m_device.received.size();
    cycles(100);
    EXPECT_FALSE(anySetPointSince(mark));
    EXPECT_FALSE(m_last.stale);
    EXPECT_EQ(requestsSince(mark), (std::vector{DeviceRequest::Stop, DeviceRequest::Disable}))
        << "it was lost in mid-move";
    EXPECT_TRUE(saw(EventCode::StoppedAfterLoss));
    EXPECT_FALSE(saw(EventCode::StoppedByController));
    EXPECT_EQ(m_last.state, RunState::Stopped);
}

TEST_F(ControlLoopTest, AnUnprotectedSenderIsShownAndNeverCommanded) {
    m_device.link = LinkState::ListenOnly;
    cycles(3);
    EXPECT_TRUE(m_last.measuredPose);
    EXPECT_FALSE(m_last.protectedLink);
    const std::size_t mark = m_device.received.size();
    run();
    cycles(20);
    EXPECT_EQ(detailOf(EventCode::CommandRefused), "run in disabled");
    for (std::size_t k = mark; k < m_device.received.size(); ++k)
        EXPECT_TRUE(!m_device.received[k].lengths && m_device.received[k].request == DeviceRequest::None);
}

TEST_F(ControlLoopTest, GivesUpAnEnableThatDoesNotCome) {
    m_device.ignoresEnable = true;
    cycles(2);
    run();
    cycles(600);
    EXPECT_EQ(detailOf(EventCode::PreparationFailed), "enable");
    EXPECT_EQ(m_last.state, RunState::Disabled);
}

TEST_F(ControlLoopTest, LegsThatDoNotArriveAreNeverCalledSettled) {
    startMoving();
    until(RunState::Settling);
    m_device.stuck = true; // a few tenths of a millimetre short
    m_device.lengths.array() -= 3.0 * kSettleWindow;
    cycles(2000);
    EXPECT_EQ(m_last.state, RunState::Settling);
    EXPECT_TRUE(saw(EventCode::NotSettled));
    EXPECT_FALSE(saw(EventCode::Settled));
}

TEST_F(ControlLoopTest, ShutDownStopsAMoveAndDisables) {
    startMoving();
    const std::size_t mark = m_device.received.size();
    m_loop->shutDown();
    EXPECT_EQ(m_device.received[mark].request, DeviceRequest::Stop);
    EXPECT_NE(m_device.state, ControllerState::Enabled);
}

TEST_F(ControlLoopTest, AStopDecidedInTheLastCycleGoesOutInTheShutDown) {
    startMoving();
    m_device.notices.push_back(notice::Refused{deviceRefusalFromWords("SET RANGE leg 1")});
    cycles(1);
    ASSERT_TRUE(saw(EventCode::StoppedOnRefusal));
    const std::size_t mark = m_device.received.size();
    m_loop->shutDown();
    EXPECT_EQ(m_device.received.at(mark).request, DeviceRequest::Stop);
}

TEST_F(ControlLoopTest, AHeldPlatformThatIsShutDownIsDisabled) {
    startMoving();
    until(RunState::Enabled);
    m_loop->shutDown();
    EXPECT_EQ(m_device.state, ControllerState::Disabled);
    EXPECT_FALSE(saw(EventCode::DisableUnconfirmed));
}

TEST_F(ControlLoopTest, ADisablingThatIsNeverConfirmedIsTold) {
    startMoving();
    until(RunState::Enabled);
    m_device.ignoresStop = m_device.ignoresDisable = true;
    m_loop->shutDown();
    EXPECT_TRUE(saw(EventCode::DisableUnconfirmed));
    EXPECT_FALSE(m_last.fresh);
}

TEST_F(ControlLoopTest, CommandsMayComeFromAnotherThread) {
    cycles(2); // commands are refused before the first measurement
    std::thread other([this] {
        for (int k = 0; k < 200; ++k)
            m_loop->post(ReferenceCommand{});
    });
    cycles(200);
    other.join();
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Disabled);
}

} // namespace
} // namespace hexapose
