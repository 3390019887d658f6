// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The loop closed on the pose, on legs that lag, are pushed, round and saturate.

#include "tests/core/machine/simulated_fixture.h"

#include <cmath>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing::SimulatedLoop;

const Pose kTarget{{0.012, -0.004, 0.040}, {0.0, 0.0, radiansFromDeg(5.0)}};
const Pose kSecond{{-0.015, 0.010, 0.015}, {radiansFromDeg(6.0), radiansFromDeg(-4.0), radiansFromDeg(-8.0)}};
const Pose kFar{{0.032, -0.030, -0.010}, {radiansFromDeg(-6.0), radiansFromDeg(7.0), radiansFromDeg(10.0)}};
constexpr double kResolution = 1e-4;

class WorkspaceLoop : public SimulatedLoop {
protected:
    struct Way {
        double largestDeviation = 0.0; ///< m, of P from the straight line
        double largestSetStep = 0.0;   ///< m, of a leg's set-point in a cycle
    };
    /// A whole move; where the true platform was beside the line.
    Way go(const Pose& target, MotionMode mode, double push = 0.0) {
        m_loop->post(RunCommand{target, mode});
        until(RunState::Moving);
        const Pose from = truePose();
        const Eigen::Vector3d line = target.offset - from.offset;
        Way way;
        for (int k = 0; k < 3000 && m_last.state != RunState::Enabled; ++k) {
            m_machine->push(2, k > 40 && k < 100 ? push : 0.0);
            const std::optional<LegLengths> before = m_last.commandedLengths;
            m_loop->cycle();
            const Eigen::Vector3d gone = truePose().offset - from.offset;
            const double part = std::clamp(gone.dot(line) / line.squaredNorm(), 0.0, 1.0);
            way.largestDeviation = std::max(way.largestDeviation, (gone - part * line).norm());
            if (before && m_last.commandedLengths)
                way.largestSetStep =
                    std::max(way.largestSetStep, (*m_last.commandedLengths - *before).cwiseAbs().maxCoeff());
        }
        EXPECT_EQ(m_last.state, RunState::Enabled) << "settles";
        return way;
    }
};

TEST_F(WorkspaceLoop, GoesStraightToTheTargetAndHoldsIt) {
    enable();
    go(kSecond, MotionMode::Workspace); // the legs' lags are learned here
    const Way way = go(kTarget, MotionMode::Workspace);
    EXPECT_LT(way.largestDeviation, 5e-4);
    EXPECT_EQ(m_last.mode, MotionMode::Workspace);
    const Twist error = displacement(truePose(), kTarget);
    EXPECT_LT(error.head<3>().norm(), 2.0 * kResolution);
    EXPECT_LT(error.tail<3>().norm(), radiansFromDeg(0.1));
}

TEST_F(WorkspaceLoop, StaysMuchCloserToTheLineThanJointModeWithAndWithoutAPush) {
    const auto worst = [&](MotionMode mode, double push) {
        enable();
        go(kSecond, MotionMode::Workspace);
        go(Pose{}, MotionMode::Workspace);
        double largest = 0.0;
        for (const Pose& target : {kSecond, kFar, kTarget, Pose{}})
            largest = std::max(largest, go(target, mode, push).largestDeviation);
        return largest;
    };
    EXPECT_GT(worst(MotionMode::Joint, 2e-3), 4.0 * worst(MotionMode::Workspace, 2e-3));
    EXPECT_GT(worst(MotionMode::Joint, 0.0), 15.0 * worst(MotionMode::Workspace, 0.0));
}

TEST_F(WorkspaceLoop, HoldsThePoseAgainstALoadAfterTheMove) {
    enable();
    go(kTarget, MotionMode::Workspace);
    m_machine->push(4, 2e-3);
    cycles(300);
    EXPECT_EQ(m_last.state, RunState::Enabled);
    EXPECT_LT(displacement(truePose(), kTarget).head<3>().norm(), 2.5 * kResolution)
        << "the load is on still";
}

TEST_F(WorkspaceLoop, SetPointsStandStillWhenThePoseIsReached) {
    enable();
    go(kTarget, MotionMode::Workspace);
    cycles(100);
    const LegLengths first = m_last.commandedLengths.value();
    double wander = 0.0;
    for (int k = 0; k < 500; ++k) {
        cycles(1);
        wander = std::max(wander, (*m_last.commandedLengths - first).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(wander, 2.0 * kResolution) << "the legs do not hunt after the rounding";
}

TEST_F(WorkspaceLoop, IsRightOnLegsOfEveryKind) {
    VirtualPlatformOptions fast, slow, even, coarse;
    fast.timeConstants.fill(0.005);
    slow.timeConstants = {0.3, 0.1, 0.25, 0.05, 0.2, 0.15};
    even.timeConstants.fill(0.1);
    coarse.resolution = 2e-4;
    coarse.noise = 5e-5;
    ControlOptions wide;
    wide.settleWindow = {5e-4, 5e-3};
    for (const auto& [legs, options] : {std::pair{fast, ControlOptions{}}, std::pair{slow, ControlOptions{}},
                                        std::pair{even, ControlOptions{}}, std::pair{coarse, wide}}) {
        build(legs, options);
        until(RunState::Unreferenced);
        go(kSecond, MotionMode::Workspace);
        const Way way = go(kTarget, MotionMode::Workspace);
        EXPECT_LT(way.largestDeviation, 1.6e-3) << legs.timeConstants[0];
    }
}

TEST_F(WorkspaceLoop, SlowsThePathForLegsThatCannotFollow) {
    VirtualPlatformOptions weak;
    weak.speedLimit = 0.012; // less than a third of what the plan takes them for
    build(weak);
    until(RunState::Unreferenced);
    const Way way = go(kTarget, MotionMode::Workspace);
    EXPECT_LT(way.largestDeviation, 2e-3) << "the direction is kept all the same";
    EXPECT_FALSE(saw(EventCode::StoppedOnFollowingError));
}

TEST_F(WorkspaceLoop, WorksWithFeedbackThatIsRare) {
    build({}, {}, 50ms);
    until(RunState::Unreferenced);
    go(kSecond, MotionMode::Workspace);
    const Way way = go(kTarget, MotionMode::Workspace);
    EXPECT_LT(way.largestDeviation, 1.5e-3);
}

TEST_F(WorkspaceLoop, SpeedZeroHoldsItOnThePathAndFullSpeedGoesOn) {
    enable();
    m_loop->post(RunCommand{kTarget, MotionMode::Workspace});
    until(RunState::Moving);
    cycles(60);
    m_loop->post(SpeedCommand{0.0});
    cycles(100);
    const Pose held = truePose();
    cycles(100);
    EXPECT_EQ(m_last.state, RunState::Moving);
    EXPECT_LT(displacement(held, truePose()).head<3>().norm(), kResolution);
    EXPECT_GT(displacement(held, kTarget).head<3>().norm(), 5e-3) << "not there yet";
    m_loop->post(SpeedCommand{1.0});
    until(RunState::Enabled);
    EXPECT_LT(displacement(truePose(), kTarget).head<3>().norm(), 2.5 * kResolution);
}

TEST_F(WorkspaceLoop, ASweepComesBackToWhereItBegan) {
    enable();
    const Pose before = truePose();
    m_loop->post(SweepCommand{{2, 0.004, 0.2, 1.0, 6.0}});
    until(RunState::Moving);
    double highest = 0.0;
    for (int k = 0; k < 2000 && m_last.state != RunState::Enabled; ++k) {
        m_loop->cycle();
        highest = std::max(highest, truePose().offset.z() - before.offset.z());
    }
    EXPECT_EQ(m_last.state, RunState::Enabled);
    EXPECT_NEAR(highest, 0.004, 1e-3);
    EXPECT_LT(displacement(truePose(), before).head<3>().norm(), 2.5 * kResolution);
    m_loop->post(SweepCommand{{2, 0.2, 0.2, 1.0, 6.0}});
    cycles(5);
    EXPECT_NE(detailOf(EventCode::MoveRefused).find("leg"), std::string::npos);
}

TEST_F(WorkspaceLoop, StopsWhereJointModeStopsToo) {
    enable();
    m_loop->post(RunCommand{kTarget, MotionMode::Workspace});
    until(RunState::Moving);
    cycles(50);
    m_loop->post(StopCommand{});
    cycles(2);
    EXPECT_EQ(m_last.state, RunState::Stopped);
    cycles(50);
    const LegLengths there = m_machine->trueLengths();
    cycles(100);
    EXPECT_EQ(m_machine->trueLengths(), there);
    EXPECT_FALSE(m_last.commandedLengths);
}

TEST_F(WorkspaceLoop, RefusesWholeWhatLeavesAStrokeOnTheWay) {
    enable();
    Pose high = kTarget;
    high.offset.z() = 0.09;
    m_loop->post(RunCommand{high, MotionMode::Workspace});
    cycles(5);
    EXPECT_NE(detailOf(EventCode::MoveRefused).find("above max_mm"), std::string::npos);
    EXPECT_EQ(m_last.state, RunState::Enabled);
}

} // namespace
} // namespace hexapose
