// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Single steps of the controller, on legs that are where the test puts them.

#include "core/tracking/workspace_controller.h"

#include "core/kinematics/inverse_kinematics.h"
#include "tests/core/motion/poses.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <random>
#include <utility>

namespace hexapose {
namespace {

using testing::laboratory;
using testing::poseMm;

using Following = WorkspaceController::Following;

constexpr double kStep = 0.01;   ///< s
constexpr double kOfSums = 1e-9; ///< rounding, of the result of some sums of products

class WorkspaceControllerTest : public ::testing::Test {
protected:
    WorkspaceControllerTest() { m_controller.begin(at(Pose{})); }

    LegLengths at(const Pose& pose) const { return legLengths(m_machine, pose); }
    WorkspaceController::Step step(const LegLengths& lengths, const Pose& pose,
                                   const PoseReference& reference) {
        return m_controller.step({lengths, pose, kStep}, reference, Following::Time, 1.0, m_limits);
    }
    /// The first step of a motion that begins at `pose`.
    WorkspaceController::Step first(const Pose& pose, const PoseReference& reference, Following following) {
        m_controller.begin(at(pose));
        return m_controller.step({at(pose), pose, kStep}, reference, following, 1.0, m_limits);
    }
    /// How far ahead of its leg a set-point has to be at most, for legs that can do no more than their speed:
    /// what they go in a cycle and in their lag.
    double furthestLead() const { return (kStep + m_controller.lags().maxCoeff()) * m_options.legSpeed; }

    const PlatformGeometry m_machine = laboratory();
    const MotionLimits m_limits = motionLimits(m_machine, {}, {});
    const WorkspaceOptions m_options{8.0, 0.04, 0.005, 0.25, 5e-5, 5e-4};
    WorkspaceController m_controller{makeModel(m_machine), m_options};
};

TEST_F(WorkspaceControllerTest, AHeldPathComesBackToFullSpeedLittleByLittle) {
    PoseReference reference;
    reference.twist[2] = 0.001; // m/s: the legs hardly leave where the test puts them
    EXPECT_EQ(step(at(Pose{}), Pose{}, reference).pathRate, 1.0);
    const LegLengths behind = at(Pose{}) - LegLengths::Constant(1.5 * m_options.gapLimit);
    EXPECT_EQ(step(behind, Pose{}, reference).pathRate, 0.0) << "held: the legs are far behind";
    double last = 0.0;
    int steps = 0;
    for (; last < 1.0 && steps < 1000; ++steps) {
        const double rate = step(at(Pose{}), Pose{}, reference).pathRate;
        ASSERT_LE(rate, last + 1.001 * kStep / m_options.speedUpTime) << steps;
        last = rate;
    }
    EXPECT_NEAR(steps * kStep, m_options.speedUpTime, 0.2 * m_options.speedUpTime);
}

TEST_F(WorkspaceControllerTest, AtRestSetPointsSlipToTheLengthsOfTheReference) {
    // Within what is left alone as rounding, and yet the set-points end where they belong.
    const Pose measured = poseMm(0.0, 0.0, 0.04, 0.0, 0.0, 0.0);
    m_controller.begin(at(measured));
    LegLengths setPoint;
    for (int k = 0; k < 300; ++k)
        setPoint = step(at(measured), measured, PoseReference{}).setPoint;
    EXPECT_LT((setPoint - at(Pose{})).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(WorkspaceControllerTest, TheAimWaitsForALegThatIsHeld) {
    PoseReference away;
    away.pose = poseMm(0.0, 0.0, 20.0, 0.0, 0.0, 0.0);
    LegLengths setPoint;
    for (int k = 0; k < 500; ++k) // 5 s in which nothing moves
        setPoint = step(at(Pose{}), Pose{}, away).setPoint;
    EXPECT_GT((setPoint - at(Pose{})).cwiseAbs().maxCoeff(), 0.9 * m_options.gapLimit) << "it pushes";
    // What the reference asks for no more must not be led to: no more than a gap of it was collected.
    setPoint = step(at(Pose{}), Pose{}, PoseReference{}).setPoint;
    EXPECT_LE((setPoint - at(Pose{})).cwiseAbs().maxCoeff(), 1.000001 * m_options.gapLimit);
}

TEST_F(WorkspaceControllerTest, FeedAndCorrectionTogetherAskNoLegForMoreThanItsSpeed) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    const auto twist = [&](double distance, double angle) {
        Twist t;
        t << part(random), part(random), part(random), part(random), part(random), part(random);
        t.head<3>() *= distance;
        t.tail<3>() *= angle;
        return t;
    };
    double largest = 0.0;
    for (int k = 0; k < 400; ++k) {
        // Of errors and speeds some are small and some more than the legs can do, alone or together.
        const double error = k % 2 ? 2e-3 : 20e-3, speed = k % 4 < 2 ? 0.02 : 0.1;
        const PoseReference reference{displaced(Pose{}, twist(error, 10.0 * error)),
                                      twist(speed, 10.0 * speed)};
        const Following following = k % 8 < 4 ? Following::Time : Following::Path;
        const LegLengths lead = first(Pose{}, reference, following).setPoint - at(Pose{});
        largest = std::max(largest, lead.cwiseAbs().maxCoeff());
        ASSERT_LE(lead.cwiseAbs().maxCoeff(), (1.0 + kOfSums) * furthestLead()) << k;
    }
    EXPECT_GT(largest, 0.99 * furthestLead()) << "what they can do is used";
}

TEST_F(WorkspaceControllerTest, ACorrectionThatIsTooFastKeepsItsDirection) {
    const Pose goal = poseMm(12.0, -20.0, 15.0, 3.0, -2.0, 4.0);
    const WorkspaceController::Step step = first(Pose{}, {goal, Twist::Zero()}, Following::Time);
    EXPECT_TRUE(step.saturated);
    const LegLengths lead = step.setPoint - at(Pose{});
    EXPECT_NEAR(lead.cwiseAbs().maxCoeff(), furthestLead(), kOfSums * furthestLead());
    const Twist way = makeModel(m_machine)->jacobian(Pose{}).fullPivLu().solve(lead);
    EXPECT_NEAR(way.normalized().dot(displacement(Pose{}, goal).normalized()), 1.0, kOfSums);
}

TEST_F(WorkspaceControllerTest, OnAPathTheReferenceWaitsForAPlatformThatLags) {
    constexpr double kSpeed = 0.010; ///< m/s
    constexpr double kLag = 0.015;   ///< s
    PoseReference reference;
    reference.twist[2] = kSpeed;
    const auto rises = [&](double behind, Following following) {
        const Pose pose = poseMm(0.0, 0.0, -1e3 * behind * kSpeed, 0.0, 0.0, 0.0);
        const WorkspaceController::Step step = first(pose, reference, following);
        return std::pair{step.pathRate, (step.setPoint - at(pose)).mean()};
    };
    const auto [evenRate, evenLead] = rises(0.0, Following::Path);
    EXPECT_EQ(evenRate, 1.0);
    for (const double behind : {kLag, -kLag}) {
        const auto [rate, lead] = rises(behind, Following::Path);
        EXPECT_LT((rate - 1.0) * behind, -0.1 * kLag) << "it waits, or goes on with it: " << behind;
        EXPECT_GT(rate, 0.0);
        EXPECT_NEAR(lead, evenLead, 1e-3 * evenLead) << "the legs go at the planned speed: " << behind;
        // With the clock it is the other way round.
        const auto [timeRate, timeLead] = rises(behind, Following::Time);
        EXPECT_EQ(timeRate, 1.0);
        EXPECT_GT((timeLead - evenLead) * behind, 0.01 * evenLead * kLag) << behind;
    }
}

} // namespace
} // namespace hexapose
