// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/control/control_loop.h"

#include "core/geometry/geometry_file.h"
#include "core/geometry/units.h"
#include "core/kinematics/newton_raphson.h"
#include "tests/support/scripted_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <thread>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing::ScriptedDevice;

// m, as the loop's defaults for the laboratory platform
constexpr double kSettleWindow = 2e-4;
constexpr double kFollowingLimit = 0.024;
constexpr double kLongestStep = 0.0008; ///< two cycles at the leg speed

Pose target() {
    return {{0.012, -0.004, 0.040}, {0.0, 0.0, radiansFromDeg(5.0)}};
}

class ControlLoopTest : public ::testing::Test {
protected:
    ControlLoopTest() {
        m_loop = std::make_unique<ControlLoop>(
            m_device, m_geometry, m_solver, ControlOptions{}, [this](const Snapshot& s) { take(s); },
            m_device.clock());
    }
    void take(const Snapshot& snapshot) {
        m_last = snapshot;
        m_states.push_back(snapshot.state);
        m_events.insert(m_events.end(), snapshot.events.begin(), snapshot.events.end());
    }
    void cycles(int count) {
        for (int k = 0; k < count; ++k)
            m_loop->cycle();
    }
    void until(RunState state, int atMost = 2000) {
        for (int k = 0; k < atMost && m_last.state != state; ++k)
            m_loop->cycle();
        ASSERT_EQ(m_last.state, state);
    }
    bool saw(EventCode code) const {
        return std::any_of(m_events.begin(), m_events.end(), [&](const Event& e) { return e.code == code; });
    }
    std::string detailOf(EventCode code) const {
        const auto found =
            std::find_if(m_events.begin(), m_events.end(), [&](const Event& e) { return e.code == code; });
        return found == m_events.end() ? "no such event" : found->detail;
    }
    void run() { m_loop->post(RunCommand{target()}); }
    /// To the middle of a move.
    void startMoving() {
        cycles(2);
        run();
        until(RunState::Moving);
        cycles(20);
    }
    bool motionWasSentSince(std::size_t mark) const {
        for (std::size_t k = mark + 1; k < m_device.received.size(); ++k) {
            const auto& a = m_device.received[k - 1].lengths;
            const auto& b = m_device.received[k].lengths;
            if (a && b && (*a - *b).norm() > 0.0)
                return true;
        }
        return false;
    }

    bool anySetPointSince(std::size_t mark) const {
        return std::any_of(m_device.received.begin() + static_cast<std::ptrdiff_t>(mark),
                           m_device.received.end(),
                           [](const SetPoints& sent) { return sent.lengths.has_value(); });
    }
    std::vector<DeviceRequest> requestsSince(std::size_t mark) const {
        std::vector<DeviceRequest> requests;
        for (std::size_t k = mark; k < m_device.received.size(); ++k)
            if (m_device.received[k].request != DeviceRequest::None)
                requests.push_back(m_device.received[k].request);
        return requests;
    }

    PlatformGeometry m_geometry = loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
    ScriptedDevice m_device{m_geometry};
    NewtonRaphson m_solver{m_geometry, NewtonOptions{}};
    Snapshot m_last;
    std::vector<RunState> m_states;
    std::vector<Event> m_events;
    std::unique_ptr<ControlLoop> m_loop;
};

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
    m_device.notices.push_back({DeviceNotice::Kind::Fault, "7", "leg 2 overcurrent"});
    m_device.state = ControllerState::Fault;
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Fault);
    EXPECT_EQ(detailOf(EventCode::ControllerFault), "7 leg 2 overcurrent");
    m_loop->post(ClearCommand{});
    cycles(2);

    startMoving();
    m_device.notices.push_back({DeviceNotice::Kind::Refused, "SET", "RANGE leg 1"});
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_EQ(detailOf(EventCode::StoppedOnRefusal), "SET RANGE leg 1");
}

TEST_F(ControlLoopTest, ARefusedSetPointIsExplainedByTheStateThatFollows) {
    const DeviceNotice refusal{DeviceNotice::Kind::Refused, "SET", "STATE drives are off"};
    startMoving();
    m_device.notices.push_back(refusal);
    cycles(1);
    EXPECT_EQ(m_last.state, RunState::Stopped) << "at once";
    m_device.state = ControllerState::Fault;
    cycles(1);
    EXPECT_EQ(detailOf(EventCode::StoppedByController), "F");

    m_events.clear();
    m_loop->post(ClearCommand{});
    cycles(3);
    startMoving();
    m_device.notices.push_back(refusal);
    cycles(1);
    m_device.notices.push_back({DeviceNotice::Kind::ClockWentBack, {}, {}});
    m_device.link = LinkState::Connecting;
    cycles(50);
    EXPECT_TRUE(saw(EventCode::ClockWentBack));
    EXPECT_FALSE(saw(EventCode::StoppedByController)) << "it restarted";

    m_events.clear();
    m_device.link = LinkState::Connected;
    m_device.state = ControllerState::Disabled;
    cycles(3);
    startMoving();
    m_device.ignoresStop = true;
    m_device.notices.push_back(refusal);
    cycles(50);
    EXPECT_EQ(detailOf(EventCode::StoppedOnRefusal), "SET STATE drives are off") << "it stays enabled";
}

TEST_F(ControlLoopTest, ALostPortShowsNothingAsLiveAndComesBackAtRest) {
    startMoving();
    m_device.link = LinkState::Lost;
    m_device.notices.push_back({DeviceNotice::Kind::LinkLost, {}, "unplugged"});
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Disconnected);
    EXPECT_TRUE(m_last.stale);
    EXPECT_FALSE(m_last.commandedLengths);
    m_device.link = LinkState::Connected;
    const std::size_t mark = m_device.received.size();
    cycles(100);
    EXPECT_FALSE(anySetPointSince(mark));
    EXPECT_FALSE(m_last.stale);
    EXPECT_EQ(requestsSince(mark), std::vector{DeviceRequest::Stop}) << "it was lost in mid-move";
    EXPECT_TRUE(saw(EventCode::StoppedAfterLoss));
    EXPECT_FALSE(saw(EventCode::StoppedByController));
    EXPECT_EQ(m_last.state, RunState::Stopped);
}

TEST_F(ControlLoopTest, NothingIsSentToAControllerThatIsEnabledAlreadyUntilTheOperatorActs) {
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

TEST_F(ControlLoopTest, ClearEndsAStopThatTheControllerHasNoStateFor) {
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

TEST_F(ControlLoopTest, AsksToReferenceAgainAndGivesUpSoonWhenNothingAnswers) {
    m_device.ignoresReference = true;
    cycles(2);
    run();
    cycles(2);
    const DeviceNotice unanswered{DeviceNotice::Kind::NoAnswer, "HOME", {}};
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

TEST_F(ControlLoopTest, AReferencingThatWasTakenMayLast) {
    m_device.ignoresReference = true;
    cycles(2);
    run();
    cycles(2);
    m_device.notices.push_back({DeviceNotice::Kind::NoAnswer, "HOME", {}});
    cycles(2);
    m_device.notices.push_back({DeviceNotice::Kind::Acknowledged, "HOME", {}});
    cycles(2);
    m_device.notices.push_back({DeviceNotice::Kind::Refused, "HOME", "STATE it is at it"});
    m_device.notices.push_back({DeviceNotice::Kind::NoAnswer, "HOME", {}});
    cycles(6000);
    EXPECT_EQ(requestsSince(0).size(), 2U);
    EXPECT_FALSE(saw(EventCode::PreparationFailed));
    m_device.state = ControllerState::Disabled;
    until(RunState::Enabled);
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

TEST_F(ControlLoopTest, ALegThatDoesNotFollowStopsTheMoveAndIsNamed) {
    startMoving();
    m_device.stuck = true;
    const std::size_t mark = m_device.received.size();
    until(RunState::Stopped);
    const std::string detail = detailOf(EventCode::StoppedOnFollowingError);
    EXPECT_EQ(detail.rfind("leg ", 0), 0u) << detail;
    EXPECT_NE(detail.find("limit 24.0 mm"), std::string::npos) << detail;
    cycles(1);
    EXPECT_EQ(m_device.received.back().request, DeviceRequest::Stop);
    const LegLengths gap = m_device.received[m_device.received.size() - 2].lengths.value() - m_device.lengths;
    EXPECT_LT(gap.cwiseAbs().maxCoeff(), kFollowingLimit + kLongestStep) << "stopped at once";
    EXPECT_GT(m_device.received.size(), mark + 10) << "an ordinary lag is no cause";
}

TEST_F(ControlLoopTest, AControllerThatTakesNoSetPointsStopsTheMove) {
    startMoving();
    m_device.deaf = true;
    const std::size_t mark = m_device.received.size();
    until(RunState::Stopped, 60);
    EXPECT_TRUE(saw(EventCode::StoppedOnNoEcho));
    EXPECT_GE(m_device.received.size(), mark + 30) << "300 ms of 10 ms cycles";
    cycles(1);
    EXPECT_EQ(m_device.received.back().request, DeviceRequest::Stop);
}

TEST_F(ControlLoopTest, NoSetPointBeyondAStrokeGoesOut) {
    startMoving();
    m_device.minLength = 0.250; // told before, and then narrowed below what the path has reached
    m_device.maxLength = 0.301;
    cycles(1);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    const std::size_t mark = m_device.received.size();
    cycles(1);
    EXPECT_EQ(m_device.received[mark].request, DeviceRequest::Stop);
    EXPECT_EQ(detailOf(EventCode::StoppedOnNewIdentity), ", 250 to 301 mm");
}

TEST_F(ControlLoopTest, AHeldPlatformBeyondItsStrokesIsStoppedBeforeASetPointGoesOut) {
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

TEST_F(ControlLoopTest, AnotherControllerInMidMoveStopsIt) {
    startMoving();
    m_device.name = "Other";
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_EQ(m_device.received.back().request, DeviceRequest::Stop);
    EXPECT_EQ(detailOf(EventCode::StoppedOnNewIdentity), "Other");
}

TEST_F(ControlLoopTest, AHostThatStoodStillGoesOnWithoutALeap) {
    startMoving();
    cycles(40);
    const std::size_t mark = m_device.received.size();
    m_device.late = 200ms;
    until(RunState::Enabled);
    constexpr double kLegSpeed = 0.04; // m/s, a stroke in 2.5 s
    for (std::size_t k = mark + 1; k < m_device.received.size(); ++k) {
        const LegLengths step = *m_device.received[k].lengths - *m_device.received[k - 1].lengths;
        EXPECT_LE(step.cwiseAbs().maxCoeff(), 1.001 * kLegSpeed * 0.030) << k;
    }
}

TEST_F(ControlLoopTest, AProtocolWithoutAnEchoIsJudgedByTheLegsAlone) {
    m_device.echoes = false;
    startMoving();
    until(RunState::Enabled);
    EXPECT_TRUE(saw(EventCode::Settled));
    cycles(100);
    EXPECT_EQ(m_last.state, RunState::Enabled);
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
    m_device.notices.push_back({DeviceNotice::Kind::Refused, "SET", "RANGE leg 1"});
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
    m_device.ignoresDisable = true;
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
