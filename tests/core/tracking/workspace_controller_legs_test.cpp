// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The controller on legs that follow its set-points: quick ones, slow ones, and such as are held.

#include "core/tracking/workspace_controller.h"

#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "tests/core/motion/poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace hexapose {
namespace {

using testing::laboratory;
using testing::poseMm;

using Following = WorkspaceController::Following;

constexpr double kGaps = 1.4;       ///< ahead of its leg a set-point is at most, with the lead for its lag
constexpr double kOfGap = 1e-12;    ///< m, rounding
constexpr double kOvershoot = 0.05; ///< of an error: what may come of legs that are not quite alike

class WorkspaceControllerOnLegs : public ::testing::Test {
protected:
    WorkspaceControllerOnLegs() { m_controller.begin(m_lengths); }

    /// A cycle at the end of which every leg has gone towards its set-point; the new pose is measured.
    void cycle(const PoseReference& reference, Following following, double seconds) {
        m_step = m_controller.step({m_lengths, m_pose, seconds}, reference, following, 1.0, m_limits);
        m_measured = m_lengths;
        for (int leg = 0; leg < kLegCount; ++leg) {
            const double share = m_lag[leg] > 0.0 ? -std::expm1(-seconds / m_lag[leg]) : 0.0;
            m_lengths[leg] += share * (m_step.setPoint[leg] - m_lengths[leg]);
        }
        const ForwardResult found = m_solver.solve(m_lengths, m_pose);
        ASSERT_EQ(found.status, SolveStatus::Converged);
        m_pose = found.pose;
    }

    const PlatformGeometry m_machine = laboratory();
    const MotionLimits m_limits = motionLimits(m_machine, {}, {});
    const WorkspaceOptions m_options{8.0, 0.04, 0.005, 0.25, 5e-5, 5e-4};
    WorkspaceController m_controller{makeModel(m_machine), m_options};
    NewtonRaphson m_solver{m_machine, NewtonOptions{}};
    LegLengths m_lag = LegLengths::Constant(0.05); ///< s, each leg's time constant; 0: it is held
    LegLengths m_lengths = legLengths(m_machine, {});
    Pose m_pose;
    LegLengths m_measured = m_lengths; ///< at the last step
    WorkspaceController::Step m_step{};
};

TEST_F(WorkspaceControllerOnLegs, SetPointsKeepToTheGapAndTheStrokesWhateverIsAskedFor) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> part(-1.0, 1.0), lag(0.02, 0.4);
    int beyond = 0, atTheEnd = 0, farAhead = 0;
    for (int motion = 0; motion < 60; ++motion) {
        // Up, down and level by turns, and further than the strokes allow.
        PoseReference reference;
        const double height = motion % 3 == 0 ? 70.0 : motion % 3 == 1 ? -70.0 : 0.0;
        const Pose goal = poseMm(10.0 * part(random), 10.0 * part(random), height, 4.0 * part(random),
                                 4.0 * part(random), 6.0 * part(random));
        for (double& seconds : m_lag)
            seconds = lag(random);
        if (motion % 10 == 9)
            m_lag[motion / 10] = 0.0;
        const Following following = motion % 2 ? Following::Path : Following::Time;
        reference.pose = m_pose;
        reference.twist = displacement(m_pose, goal) / 2.0; // in 2 s
        m_controller.begin(m_step.setPoint.isZero(0.0) ? m_lengths : m_step.setPoint);
        for (int k = 0; k < 300; ++k) {
            if (k == 200)
                reference = {goal, Twist::Zero()};
            ASSERT_NO_FATAL_FAILURE(cycle(reference, following, 0.01)) << motion << ", cycle " << k;
            reference.pose = displaced(reference.pose, m_step.pathRate * 0.01 * reference.twist);
            const LegLengths& set = m_step.setPoint;
            ASSERT_GE((set - m_limits.minLength).minCoeff(), 0.0) << motion << ", cycle " << k;
            ASSERT_LE((set - m_limits.maxLength).maxCoeff(), 0.0) << motion << ", cycle " << k;
            const double ahead = (set - m_measured).cwiseAbs().maxCoeff();
            ASSERT_LE(ahead, kGaps * m_options.gapLimit + kOfGap) << motion << ", cycle " << k;
            farAhead += ahead > m_options.gapLimit;
            atTheEnd +=
                (set - m_limits.minLength).minCoeff() == 0.0 || (set - m_limits.maxLength).maxCoeff() == 0.0;
        }
        beyond += !checkLegs(m_limits, legLengths(m_machine, goal)).ok();
    }
    EXPECT_GT(beyond, 20) << "goals that no leg may reach";
    EXPECT_GT(atTheEnd, 100);
    EXPECT_GT(farAhead, 100);
}

TEST_F(WorkspaceControllerOnLegs, TheCorrectionDoesNotOvershootHoweverRareTheFeedbackIs) {
    const Pose goal = poseMm(0.5, -0.3, 1.0, 0.0, 0.0, 0.0);
    const Eigen::Vector3d way = goal.offset.normalized();
    const double whole = goal.offset.norm();
    for (const double period : {0.01, 0.02, 0.05, 0.1, 0.2, 0.4}) {
        m_lengths = legLengths(m_machine, {});
        m_pose = {};
        m_controller.begin(m_lengths);
        double furthest = 0.0;
        for (double t = 0.0; t < std::max(3.0, 20.0 * period); t += period) {
            ASSERT_NO_FATAL_FAILURE(cycle({goal, Twist::Zero()}, Following::Time, period)) << period;
            furthest = std::max(furthest, m_pose.offset.dot(way));
        }
        EXPECT_LT(furthest, (1.0 + kOvershoot) * whole) << "every " << period << " s";
        EXPECT_LT((m_pose.offset - goal.offset).norm(), 2.0 * m_options.restDistance)
            << "every " << period << " s";
    }
}

} // namespace
} // namespace hexapose
