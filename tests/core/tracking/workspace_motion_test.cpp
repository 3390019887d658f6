// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/tracking/workspace_motion.h"

#include "core/motion/straight_motion.h"
#include "tests/core/motion/poses.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using testing::laboratory;
using testing::poseMm;

constexpr double kMotionCycle = 0.01; ///< s

class WorkspaceMotionTest : public ::testing::Test {
protected:
    Pose whereItShouldBe() const { return m_law.reference()->pose; }
    /// A cycle on a platform that is where it should be.
    MotionGenerator::Cycle fresh() const {
        const Pose pose = whereItShouldBe();
        return {kMotionCycle, 1.0, m_model->actuators(pose), pose, m_limits};
    }

    const PlatformGeometry m_machine = laboratory();
    const MotionLimits m_limits = motionLimits(m_machine, {}, {});
    const SharedModel m_model = makeModel(m_machine);
    const MotionBounds m_bounds = withDefaults({}, m_machine);
    WorkspaceController m_controller{m_model, {8.0, m_bounds.legSpeed, 0.01, 0.25, 5e-5, 5e-4}};
    WorkspaceMotion m_law{
        m_controller,
        std::make_shared<StraightMotion>(*m_model, Pose{}, poseMm(10.0, 5.0, 20.0, 0.0, 0.0, 0.0), m_bounds),
        WorkspaceController::Following::Path, m_model->actuators({})};
};

TEST_F(WorkspaceMotionTest, WithoutAFreshPoseItHoldsTheSetPointAndStaysOnThePath) {
    LegLengths last;
    for (int k = 0; k < 40; ++k)
        last = m_law.step(fresh());
    const Pose there = whereItShouldBe();
    ASSERT_GT(there.offset.norm(), 1e-3) << "in mid-path";
    MotionGenerator::Cycle noPose = fresh(), noLengths = fresh(), neither = fresh();
    noPose.pose.reset(); // legs were measured, of which no pose was found
    noLengths.lengths.reset();
    neither.pose.reset();
    neither.lengths.reset();
    for (const MotionGenerator::Cycle& cycle : {noPose, noLengths, neither}) {
        EXPECT_EQ(m_law.step(cycle), last);
        EXPECT_EQ(whereItShouldBe().toVector(), there.toVector());
    }
    // Then it goes on.
    EXPECT_NE(m_law.step(fresh()), last);
    EXPECT_GT(whereItShouldBe().offset.norm(), there.offset.norm());
}

} // namespace
} // namespace hexapose
