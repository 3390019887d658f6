// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Single steps of the controller, on legs that are where the test puts them.

#include "core/tracking/workspace_controller.h"

#include "core/kinematics/inverse_kinematics.h"
#include "tests/core/motion/poses.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using testing::laboratory;
using testing::poseMm;

using Following = WorkspaceController::Following;

constexpr double kStep = 0.01; ///< s

class WorkspaceControllerTest : public ::testing::Test {
protected:
    WorkspaceControllerTest() { m_controller.begin(at(Pose{})); }

    LegLengths at(const Pose& pose) const { return legLengths(m_machine, pose); }
    WorkspaceController::Step step(const LegLengths& lengths, const Pose& pose,
                                   const PoseReference& reference) {
        return m_controller.step({lengths, pose, kStep}, reference, Following::Time, 1.0, m_limits);
    }

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

} // namespace
} // namespace hexapose
