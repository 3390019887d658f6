// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Hold-to-run.

#include "tests/core/machine/simulated_fixture.h"

#include <cmath>

namespace hexapose {
namespace {

using testing::SimulatedLoop;

constexpr double kSettled = 2.5e-4; ///< m, of the resolution and the window

class Jog : public SimulatedLoop {
protected:
    /// Held for some cycles, said again in every fifth.
    void hold(const JogDirection& direction, int count, double part = 1.0) {
        for (int k = 0; k < count; ++k) {
            if (k % 5 == 0)
                m_loop->post(JogCommand{direction, part});
            m_loop->cycle();
        }
    }
};

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
