// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/motion_planner.h"

#include "core/kinematics/inverse_kinematics.h"
#include "core/motion/leg_path_check.h"
#include "core/motion/leg_trajectory.h"
#include "core/motion/pose_motion_check.h"
#include "core/motion/straight_motion.h"
#include "tests/core/motion/poses.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace hexapose::planningtest {
namespace {

using testing::poseMm;
using Reason = MotionCheck::Reason;

constexpr double kStartSlack = 2e-4; ///< m
constexpr int kPlans = 60;

/// Time that goes on by a second with each look at it.
PlanBudget looks(int count) {
    auto taken = std::make_shared<int>(0);
    return {std::chrono::seconds(count), [taken] { return std::chrono::seconds((*taken)++); }};
}

class MotionPlanner : public ::testing::Test {
protected:
    MotionPlanner() {
        m_limits = motionLimits(m_machine, std::nullopt, std::nullopt);
        m_limits.legSpeed = m_bounds.legSpeed;
        m_limits.legAcceleration = m_bounds.legAcceleration;
    }
    PlanStart startAt(const Pose& pose) const { return {legLengths(m_machine, pose), pose}; }
    PlannedMotion plan(const PlanStart& start, const MotionRequest& request,
                       const PlanBudget& budget = {}) const {
        return planMotion(m_model, m_bounds, m_limits, kStartSlack, start, request, budget);
    }
    Pose randomPose(double metres, double radians) {
        PoseVector v;
        for (int k = 0; k < 6; ++k)
            v[k] = (k < 3 ? metres : radians) * m_unit(m_random);
        return Pose::fromVector(v);
    }

    const PlatformGeometry m_machine = testing::laboratory();
    const PlatformModel m_model{m_machine};
    const MotionBounds m_bounds = withDefaults(MotionBounds{}, m_machine);
    MotionLimits m_limits;
    std::mt19937_64 m_random{3};
    std::uniform_real_distribution<double> m_unit{-1.0, 1.0};
};

void expectSame(const MotionCheck& a, const MotionCheck& b) {
    EXPECT_EQ(a.reason, b.reason);
    EXPECT_EQ(a.leg, b.leg);
    EXPECT_EQ(a.axis, b.axis);
    EXPECT_EQ(a.value, b.value);
    EXPECT_EQ(a.bound, b.bound);
    EXPECT_EQ(a.fraction, b.fraction);
}

TEST_F(MotionPlanner, DecidesInJointModeAsTheCheckOfTheLegPath) {
    int accepted = 0;
    for (int i = 0; i < kPlans; ++i) {
        const Pose from = randomPose(0.03, 0.3), to = randomPose(0.05, 0.5);
        const PlannedMotion planned = plan(startAt(from), StraightMove{to, MotionMode::Joint});
        expectSame(planned.check, checkLegPath(m_model, m_limits, from, to));
        if (!planned.check.ok())
            continue;
        ++accepted;
        EXPECT_EQ(planned.motion, nullptr);
        EXPECT_EQ(planned.endLengths, legLengths(m_machine, to));
        const LegTrajectory path(legLengths(m_machine, from), planned.endLengths, m_bounds.legSpeed);
        EXPECT_EQ(planned.duration, std::chrono::duration<double>(path.duration()).count());
    }
    EXPECT_GT(accepted, 5);
    EXPECT_LT(accepted, kPlans);
}

TEST_F(MotionPlanner, DecidesInWorkspaceModeAsTheChecksOfTargetAndMotion) {
    int accepted = 0;
    for (int i = 0; i < kPlans; ++i) {
        const Pose from = randomPose(0.03, 0.3), to = randomPose(0.05, 0.5);
        const PlannedMotion planned = plan(startAt(from), StraightMove{to, MotionMode::Workspace});
        const MotionLimits along = limitsFrom(m_limits, legLengths(m_machine, from), kStartSlack);
        const MotionCheck target = checkPose(m_model, m_limits, to);
        expectSame(planned.check,
                   target.ok() ? checkMotion(m_model, along, StraightMotion(m_model, from, to, m_bounds))
                               : target);
        if (!planned.check.ok())
            continue;
        ++accepted;
        ASSERT_NE(planned.motion, nullptr);
        EXPECT_EQ(planned.duration, planned.motion->duration());
        EXPECT_EQ(planned.endLengths, legLengths(m_machine, to));
    }
    EXPECT_GT(accepted, 5);
    EXPECT_LT(accepted, kPlans);
}

TEST_F(MotionPlanner, PlansASweepAboutTheStart) {
    const Pose centre = poseMm(3, 4, 5, 1, 2, 3);
    const PlannedMotion planned = plan(startAt(centre), SweepSettings{2, 0.005, 0.1, 0.5, 10.0});
    EXPECT_TRUE(planned.check.ok());
    EXPECT_EQ(planned.mode(), MotionMode::Workspace);
    EXPECT_EQ(planned.endPose().toVector(), centre.toVector());
    EXPECT_EQ(planned.endLengths, legLengths(m_machine, centre));
    EXPECT_EQ(planned.duration, 10.0);
    EXPECT_EQ(plan(startAt(centre), SweepSettings{2, 0.005, 0.1, 5.0, 10.0}).check.reason, Reason::LegSpeed);
    EXPECT_EQ(plan(startAt(centre), SweepSettings{7, 0.005, 0.1, 5.0, 10.0}).check.reason, Reason::NotFinite);
}

/// The leg is a hair beyond its stroke where it starts, by its noise, and goes back into it.
TEST_F(MotionPlanner, LetsALegStartALittleBeyondItsStroke) {
    const Pose from = poseMm(0, 0, 20, 0, 0, 0);
    m_limits.maxLength = legLengths(m_machine, from).array() - 0.5 * kStartSlack;
    const StraightMove home{Pose{}, MotionMode::Workspace};
    EXPECT_TRUE(plan(startAt(from), home).check.ok());
    m_limits.maxLength.array() -= kStartSlack;
    EXPECT_EQ(plan(startAt(from), home).check.reason, Reason::LegAboveMax);
}

TEST_F(MotionPlanner, RefusesWhatIsNoNumber) {
    const double nan = std::nan("");
    for (const MotionMode mode : {MotionMode::Joint, MotionMode::Workspace}) {
        EXPECT_EQ(plan(startAt(Pose{}), StraightMove{poseMm(nan, 0, 0, 0, 0, 0), mode}).check.reason,
                  Reason::NotFinite);
        EXPECT_EQ(plan(startAt(poseMm(0, 0, 0, nan, 0, 0)), StraightMove{Pose{}, mode}).check.reason,
                  Reason::NotFinite);
        PlanStart start = startAt(Pose{});
        start.setPoint[3] = std::numeric_limits<double>::infinity();
        EXPECT_EQ(plan(start, StraightMove{poseMm(0, 0, 5, 0, 0, 0), mode}).check.reason, Reason::NotFinite);
    }
}

/// Whenever the time runs out, the plan is refused and says how far it came; it never says ok unchecked.
TEST_F(MotionPlanner, RefusesWhatTakesLongerThanItsBudget) {
    const Pose from = poseMm(-10, 5, -12, 4, -3, 2), to = poseMm(12, -4, 20, -3, 4, 6);
    const std::array<MotionRequest, 3> requests{StraightMove{to, MotionMode::Joint},
                                                StraightMove{to, MotionMode::Workspace},
                                                SweepSettings{2, 0.005, 0.1, 0.5, 10.0}};
    for (const MotionRequest& request : requests) {
        int budget = 1;
        double reached = 0.0;
        PlannedMotion planned = plan(startAt(from), request, looks(budget));
        while (planned.check.reason == Reason::PlanTooLong && budget < 10000) {
            EXPECT_GE(planned.check.fraction, reached);
            EXPECT_LT(planned.check.fraction, 1.0);
            reached = planned.check.fraction;
            planned = plan(startAt(from), request, looks(++budget));
        }
        EXPECT_GT(budget, 1) << request.index() << ": looks at its time at all";
        EXPECT_GT(reached, 0.5) << request.index();
        EXPECT_TRUE(planned.check.ok()) << request.index();
    }
}

TEST_F(MotionPlanner, BeginsOnlyWhereAndUnderWhatWasPlanned) {
    const Pose from = poseMm(-10, 5, -12, 4, -3, 2);
    const PlannedMotion planned =
        plan(startAt(from), StraightMove{poseMm(12, -4, 20, -3, 4, 6), MotionMode::Workspace});
    ASSERT_TRUE(planned.check.ok());
    const auto check = [&](const PlanStart& now) { return checkStart(planned, now, m_limits, 1e-3, 1e-2); };
    EXPECT_TRUE(check(startAt(from)).ok());
    PlanStart moved = startAt(from);
    moved.setPoint[4] += 0.9e-3;
    moved.pose.offset[0] -= 0.9e-3;
    moved.pose.angles.alpha += 0.9e-2;
    EXPECT_TRUE(check(moved).ok());
    moved.setPoint[4] += 0.2e-3;
    EXPECT_EQ(check(moved).reason, Reason::StartMoved);
    EXPECT_EQ(check(moved).leg, 5);
    EXPECT_NEAR(check(moved).value, 1.1e-3, 1e-12);
    moved = startAt(from);
    moved.pose.offset[0] -= 1.1e-3;
    EXPECT_EQ(check(moved).reason, Reason::StartMoved);
    moved = startAt(from);
    moved.pose.angles.gamma += 1.1e-2;
    EXPECT_EQ(check(moved).reason, Reason::StartMoved);
    moved.pose.angles.gamma = std::nan("");
    EXPECT_EQ(check(moved).reason, Reason::StartMoved);

    const auto under = [&](auto change) {
        MotionLimits limits = m_limits;
        change(limits);
        return checkStart(planned, startAt(from), limits, 1e-3, 1e-2).reason;
    };
    EXPECT_EQ(under([](MotionLimits& l) { l.minLength[0] += 1e-3; }), Reason::LimitsChanged);
    EXPECT_EQ(under([](MotionLimits& l) { l.maxLength[5] -= 1e-3; }), Reason::LimitsChanged);
    EXPECT_EQ(under([](MotionLimits& l) { l.envelope.furthest[2] = 0.1; }), Reason::LimitsChanged);
    EXPECT_EQ(under([](MotionLimits& l) { l.singularityMargin *= 2.0; }), Reason::LimitsChanged);
    EXPECT_EQ(under([](MotionLimits& l) { l.leastDeterminantRatio *= 2.0; }), Reason::LimitsChanged);
    EXPECT_EQ(under([](MotionLimits& l) { l.legSpeed *= 0.5; }), Reason::LimitsChanged);
    EXPECT_EQ(under([](MotionLimits& l) { l.legAcceleration *= 0.5; }), Reason::LimitsChanged);
    EXPECT_EQ(under([](MotionLimits&) {}), Reason::Ok);

    const PlannedMotion refused = plan(startAt(from), StraightMove{poseMm(0, 0, 900, 0, 0, 0), {}});
    EXPECT_EQ(checkStart(refused, startAt(from), m_limits, 1.0, 1.0).reason, Reason::LegAboveMax);
}

/// How many looks at the time a plan takes that is accepted; one look is 16 steps of its loops.
int looksOf(const PlatformGeometry& machine, const Pose& from, const StraightMove& move) {
    const MotionBounds bounds = withDefaults(MotionBounds{}, machine);
    MotionLimits limits = motionLimits(machine, std::nullopt, std::nullopt);
    limits.legSpeed = bounds.legSpeed;
    limits.legAcceleration = bounds.legAcceleration;
    int taken = 0;
    const PlanBudget budget{std::chrono::hours(100000), [&] { return std::chrono::seconds(taken++); }};
    const PlannedMotion planned = planMotion(PlatformModel(machine), bounds, limits, kStartSlack,
                                             {legLengths(machine, from), from}, move, budget);
    EXPECT_TRUE(planned.check.ok()) << static_cast<int>(planned.check.reason);
    return taken;
}

/// From a fuzzer: for most of this path the smallest singular value is little above the margin. It took
/// 25,000 steps and 0.36 s.
TEST(MotionPlannerCost, OfALegPathNearTheMargin) {
    PlatformGeometry machine = testing::laboratory();
    for (std::size_t i = 0; i < kLegCount; ++i) {
        const double home = machine.homeLengths()[static_cast<int>(i)];
        machine.legs[i].minLength = 0.55 * home;
        machine.legs[i].maxLength = 1.45 * home;
    }
    const Pose from = poseMm(-64.0489675, -19.6652436, -13.3603402, -60.7465414, -58.5573279, -16.3378257);
    const Pose to = poseMm(-30.310653, -101.987168, 30.1891191, -60.6441724, -31.6973457, -52.1687385);
    EXPECT_LT(looksOf(machine, Pose{}, {from, MotionMode::Joint}), 50);
    EXPECT_LT(looksOf(machine, from, {to, MotionMode::Joint}), 50);
}

/// The bounds between two samples are those of the joints, wherever P was put. With P 100 mm from legs of
/// 6 mm a plan took 0.7 s.
TEST(MotionPlannerCost, DependsNotOnWherePWasPut) {
    PlatformGeometry small = testing::laboratory();
    small.p_OP_home_B *= 0.02;
    for (Leg& leg : small.legs) {
        leg.p_OA_B *= 0.02;
        leg.p_PB_P *= 0.02;
        leg.minLength = 0.005;
        leg.maxLength = 0.007;
    }
    const auto planLooks = [&](double below) {
        PlatformGeometry machine = small;
        machine.p_OP_home_B[2] -= below;
        for (Leg& leg : machine.legs)
            leg.p_PB_P[2] += below;
        // The joints go the same way: about them, by as little as this, P goes nearly straight.
        const EulerAngles angles{0.002, -0.001, 0.01};
        const Eigen::Vector3d arm(0.0, 0.0, below);
        const Pose to{Eigen::Vector3d(2e-4, -1e-4, 3e-4) + arm - rotationMatrix(angles) * arm, angles};
        return looksOf(machine, Pose{}, {to, MotionMode::Workspace});
    };
    const int among = planLooks(0.0);
    EXPECT_LT(planLooks(0.1), 1.5 * among);
    EXPECT_LT(planLooks(10.0), 1.5 * among);
    const auto fuzzed = [&] {
        PlatformGeometry machine = small;
        machine.p_OP_home_B[2] -= 0.1;
        for (Leg& leg : machine.legs)
            leg.p_PB_P[2] += 0.1;
        return looksOf(
            machine, Pose{},
            {poseMm(2.095104966, 13.74473256, 1.362742007, 8.007710774, 0.3186091354, -11.34268807),
             MotionMode::Workspace});
    };
    EXPECT_LT(fuzzed(), 150);
}

/// Legs of kilometres that go 80 mm/s: hours, hundreds of thousands of times as long as the jerk takes.
TEST(MotionPlannerCost, DependsNotOnTheSizeOfTheMachine) {
    const auto planLooks = [](double scale) {
        PlatformGeometry machine = testing::laboratory();
        machine.p_OP_home_B *= scale;
        for (Leg& leg : machine.legs) {
            leg.p_OA_B *= scale;
            leg.p_PB_P *= scale;
            leg.minLength *= scale;
            leg.maxLength *= scale;
        }
        Pose to = poseMm(12, -4, 20, -3, 4, 6);
        to.offset *= scale;
        return looksOf(machine, Pose{}, {to, MotionMode::Workspace});
    };
    const int laboratory = planLooks(1.0);
    EXPECT_LT(planLooks(1e4), 6 * laboratory);
    EXPECT_LT(planLooks(1e8), 6 * laboratory);
}

} // namespace
} // namespace hexapose::planningtest
