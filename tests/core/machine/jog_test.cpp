// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Hold-to-run.

#include "tests/core/machine/simulated_fixture.h"

#include <algorithm>
#include <cmath>

namespace hexapose {
namespace {

using testing::SimulatedLoop;

constexpr double kSettled = 2.5e-4; ///< m, of the resolution and the window

class Jog : public SimulatedLoop {
protected:
    /// Held for some cycles, said again in every fifth.
    void hold(const JogDirection& direction, int count, double part = 1.0, MotionId id = kNoMotion) {
        for (int k = 0; k < count; ++k) {
            if (k % 5 == 0)
                m_loop->post(JogCommand{direction, part, id});
            m_loop->cycle();
        }
    }
    int starts() const {
        return static_cast<int>(std::count_if(m_events.begin(), m_events.end(), [](const Event& e) {
            return e.code == EventCode::JogStarted;
        }));
    }
    /// Along x while repeats of a press arrive that is over; and that a new press jogs.
    void expectNothingMoreOf(MotionId id, const JogDirection& direction, double farthest) {
        const Pose before = truePose();
        hold(direction, 200, 1.0, id);
        EXPECT_EQ(m_last.state, RunState::Enabled);
        EXPECT_EQ(starts(), 1);
        EXPECT_LT(displacement(before, truePose()).head<3>().norm(), farthest);
        hold(direction, 60, 1.0, id + 1);
        EXPECT_EQ(m_last.state, RunState::Moving) << "another press is another jog";
        EXPECT_EQ(starts(), 2);
        EXPECT_FALSE(saw(EventCode::CommandRefused));
    }
};

constexpr double kStoppingDistance = 0.012; ///< m, from full speed, with the lag of the legs
constexpr MotionId kPress = 7;

TEST_F(Jog, MovesAlongItsAxisWhileHeldAndRestsWhenReleased) {
    enable();
    for (const bool up : {true, false}) {
        const Pose before = truePose();
        hold({0, up}, 100);
        EXPECT_EQ(m_last.state, RunState::Moving);
        m_loop->post(JogReleaseCommand{});
        until(RunState::Enabled);
        const Twist gone = displacement(before, truePose());
        EXPECT_GT(up ? gone[0] : -gone[0], 0.01);
        EXPECT_LT(std::abs(gone[1]), kSettled);
        EXPECT_LT(std::abs(gone[2]), kSettled);
        EXPECT_LT(gone.tail<3>().norm(), 3e-3);
        const Pose rest = truePose();
        cycles(100);
        EXPECT_LT(displacement(rest, truePose()).head<3>().norm(), kSettled);
    }
    EXPECT_TRUE(saw(EventCode::JogStarted));
}

TEST_F(Jog, TurnsAboutAnAxisThroughPAndThePlatformsOwnAxesTurnWithIt) {
    enable();
    m_loop->post(
        RunCommand{{Eigen::Vector3d::Zero(), {0.0, 0.0, radiansFromDeg(20.0)}}, MotionMode::Workspace});
    until(RunState::Settling);
    until(RunState::Enabled);
    const Pose before = truePose();
    hold({0, true, JogFrame::Platform}, 100);
    m_loop->post(JogReleaseCommand{});
    until(RunState::Enabled);
    const Twist gone = displacement(before, truePose());
    EXPECT_NEAR(std::atan2(gone[1], gone[0]), radiansFromDeg(20.0), 0.02);
    const Pose there = truePose();
    hold({3, true, JogFrame::Platform}, 100);
    m_loop->post(JogReleaseCommand{});
    until(RunState::Enabled);
    const Twist turned = displacement(there, truePose());
    EXPECT_LT(turned.head<3>().norm(), 2.0 * kSettled) << "P stays";
    EXPECT_NEAR(std::atan2(turned[4], turned[3]), radiansFromDeg(20.0), 0.05);
}

TEST_F(Jog, ThatIsNotSaidAgainComesToRest) {
    enable();
    hold({2, true}, 60);
    ASSERT_EQ(m_last.state, RunState::Moving);
    cycles(80); // a stalled screen says nothing any more
    EXPECT_NE(m_last.state, RunState::Moving);
    const Pose rest = truePose();
    cycles(100);
    EXPECT_LT(displacement(rest, truePose()).head<3>().norm(), kSettled);
}

TEST_F(Jog, PressThatWasReleasedStartsNothingMore) {
    enable();
    const JogDirection x{0, true};
    hold(x, 100, 1.0, kPress);
    ASSERT_EQ(m_last.state, RunState::Moving);
    m_loop->post(JogReleaseCommand{});
    m_loop->cycle();
    ASSERT_EQ(m_last.state, RunState::Moving) << "it takes time to come to rest";
    expectNothingMoreOf(kPress, x, kStoppingDistance);
}

TEST_F(Jog, PressThatTimedOutStartsNothingMoreWhileItSlowsDown) {
    enable();
    const JogDirection x{0, true};
    hold(x, 100, 1.0, kPress);
    cycles(25); // 250 ms
    ASSERT_EQ(m_last.state, RunState::Moving);
    expectNothingMoreOf(kPress, x, kStoppingDistance);
}

TEST_F(Jog, PressThatTimedOutStartsNothingMoreWhileItSettles) {
    enable();
    const JogDirection x{0, true};
    hold(x, 100, 1.0, kPress);
    until(RunState::Settling);
    expectNothingMoreOf(kPress, x, kStoppingDistance);
}

TEST_F(Jog, PressThatSettledOrWasStoppedStartsNothingMore) {
    enable();
    const JogDirection x{0, true};
    hold(x, 60, 1.0, kPress);
    m_loop->post(JogReleaseCommand{});
    until(RunState::Enabled);
    expectNothingMoreOf(kPress, x, kSettled);
    m_loop->post(StopCommand{}); // the next press, in the middle of its jog
    until(RunState::Stopped);
    m_loop->post(ClearCommand{});
    until(RunState::Disabled);
    m_loop->post(EnableCommand{});
    until(RunState::Enabled);
    hold(x, 60, 1.0, kPress + 1);
    EXPECT_EQ(m_last.state, RunState::Enabled);
    EXPECT_EQ(starts(), 2);
}

/// A motion of somebody else, and a press without an id, leave what is known of the press before.
TEST_F(Jog, PressThatEndedIsRememberedBeyondTheNextMotion) {
    enable();
    const JogDirection x{0, true};
    hold(x, 60, 1.0, kPress);
    m_loop->post(JogReleaseCommand{});
    until(RunState::Settling);
    m_loop->post(RunCommand{Pose{}, MotionMode::Workspace, kPress + 10});
    until(RunState::Moving);
    m_loop->post(JogReleaseCommand{});
    until(RunState::Enabled);
    hold({1, true}, 20);
    m_loop->post(JogReleaseCommand{});
    until(RunState::Enabled);
    const int before = starts();
    hold(x, 60, 1.0, kPress);
    EXPECT_EQ(m_last.state, RunState::Enabled);
    EXPECT_EQ(starts(), before);
}

TEST_F(Jog, RestsBeforeAStrokeEndsAndSaysWhy) {
    enable();
    for (int k = 0; k < 3000 && m_last.state != RunState::Stopped && !saw(EventCode::JogLimited); ++k) {
        if (k % 5 == 0)
            m_loop->post(JogCommand{{2, true}, 1.0});
        m_loop->cycle();
    }
    EXPECT_NE(detailOf(EventCode::JogLimited).find("above max_mm"), std::string::npos);
    hold({2, true}, 150);
    EXPECT_NE(m_last.state, RunState::Stopped) << "no stop: it came to rest in time";
    const MotionLimits limits = motionLimits(m_geometry, {}, {});
    EXPECT_LT((m_machine->trueLengths() - limits.maxLength).maxCoeff(), 0.0);
    EXPECT_GT((m_machine->trueLengths() - limits.maxLength).maxCoeff(), -0.01) << "and not far before";
    m_loop->post(JogReleaseCommand{});
    until(RunState::Enabled);
    const Pose before = truePose();
    hold({2, false}, 60); // away from the limit it goes again
    EXPECT_LT(truePose().offset.z(), before.offset.z() - 1e-3);
}

TEST_F(Jog, OnlyWhileEnabledAndNeverAfterAStop) {
    build();
    until(RunState::Unreferenced);
    hold({0, true}, 10);
    EXPECT_EQ(detailOf(EventCode::CommandRefused), "jog in unreferenced");
    enable();
    hold({0, true}, 60);
    m_loop->post(StopCommand{});
    hold({0, true}, 30);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    EXPECT_EQ(detailOf(EventCode::CommandRefused), "jog in stopped");
}

TEST_F(Jog, GoesAtThePartOfFullSpeedThatIsAskedFor) {
    enable();
    double speeds[2];
    for (const int half : {0, 1}) {
        hold({1, true}, 60, half ? 0.5 : 1.0);
        const Pose before = truePose();
        hold({1, true}, 20, half ? 0.5 : 1.0);
        speeds[half] = displacement(before, truePose()).head<3>().norm();
        m_loop->post(JogReleaseCommand{});
        until(RunState::Enabled);
        m_loop->post(RunCommand{Pose{}, MotionMode::Workspace});
        until(RunState::Moving);
        until(RunState::Enabled);
    }
    EXPECT_NEAR(speeds[1], 0.5 * speeds[0], 0.05 * speeds[0]);
}

TEST(JogSteps, GoInTheFrameThatIsAskedFor) {
    const Pose pose{{0.01, 0.02, 0.03}, {0.0, 0.0, radiansFromDeg(90.0)}};
    EXPECT_LT(
        (stepped(pose, {0, true, JogFrame::Base}, 0.001).offset - Eigen::Vector3d(0.011, 0.02, 0.03)).norm(),
        1e-12);
    EXPECT_LT(
        (stepped(pose, {0, true, JogFrame::Platform}, 0.001).offset - Eigen::Vector3d(0.01, 0.021, 0.03))
            .norm(),
        1e-12);
    EXPECT_NEAR(stepped(pose, {5, false, JogFrame::Platform}, radiansFromDeg(1.0)).angles.gamma,
                radiansFromDeg(89.0), 1e-12);
}

} // namespace
} // namespace hexapose
