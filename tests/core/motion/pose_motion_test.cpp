// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/kinematics/jacobian.h"
#include "core/motion/sine_sweep.h"
#include "core/motion/straight_motion.h"
#include "tests/core/motion/poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hexapose {
namespace {

using testing::laboratory;
using testing::poseMm;

constexpr int kLooks = 2000;
constexpr double kBoundSlack = 5e-3; ///< of a limit

/// The twist is the derivative of the pose, and the bounds of a point far from P are bounds, and near ones.
void expectConsistent(const PoseMotion& motion) {
    const Eigen::Vector3d p_PC_P(0.03, -0.2, 0.11);
    const auto point = [&](double t) -> Eigen::Vector3d {
        const Pose pose = motion.at(t).pose;
        return pose.offset + rotationMatrix(pose.angles) * p_PC_P;
    };
    const RateBounds ofP = motion.rateBounds(Eigen::Vector3d::Zero());
    const RateBounds ofC = motion.rateBounds(p_PC_P);
    const double h = motion.duration() / kLooks;
    RateBounds reached;
    for (int i = 1; i < kLooks; ++i) {
        const PoseReference at = motion.at(i * h);
        const Twist moved = displacement(motion.at((i - 0.5) * h).pose, motion.at((i + 0.5) * h).pose) / h;
        EXPECT_LT((moved - at.twist).norm(), 2e-3 * (ofP.speed + ofP.angularSpeed)) << i;
        EXPECT_LE(at.twist.head<3>().norm(), ofP.speed * (1.0 + 1e-9) + 1e-12);
        EXPECT_LE(at.twist.tail<3>().norm(), ofP.angularSpeed * (1.0 + 1e-9) + 1e-12);
        const Twist before = motion.at((i - 1) * h).twist, after = motion.at((i + 1) * h).twist;
        EXPECT_LE((after - before).tail<3>().norm() / (2.0 * h),
                  ofP.angularAcceleration * (1.0 + 1e-6) + 1e-9);
        reached.speed = std::max(reached.speed, (point((i + 1) * h) - point((i - 1) * h)).norm() / (2.0 * h));
        reached.acceleration =
            std::max(reached.acceleration,
                     (point((i + 1) * h) - 2.0 * point(i * h) + point((i - 1) * h)).norm() / (h * h));
    }
    EXPECT_LE(reached.speed, ofC.speed * (1.0 + 1e-6));
    EXPECT_GE(reached.speed, 0.4 * ofC.speed);
    EXPECT_LE(reached.acceleration, ofC.acceleration * (1.0 + 1e-6));
    EXPECT_GE(reached.acceleration, 0.2 * ofC.acceleration);
}

TEST(Displacement, LeadsFromOnePoseToTheOtherTheShorterWay) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        PoseVector a, b;
        for (int k = 0; k < 6; ++k) {
            a[k] = unit(random);
            b[k] = unit(random) * (k < 3 ? 1.0 : 1.5);
        }
        const Pose from = Pose::fromVector(a), to = Pose::fromVector(b);
        const Twist way = displacement(from, to);
        EXPECT_LE(way.tail<3>().norm(), 3.1415926535898);
        const Pose there = displaced(from, way);
        EXPECT_LT((there.offset - to.offset).norm(), 1e-14);
        EXPECT_LT((rotationMatrix(there.angles) - rotationMatrix(to.angles)).norm(), 1e-12);
    }
    EXPECT_EQ(displacement(Pose{}, Pose{}), Twist::Zero());
    const Twist tiny = displacement(Pose{}, Pose{Eigen::Vector3d::Zero(), {0.0, 0.0, 1e-12}});
    EXPECT_NEAR(tiny[5], 1e-12, 1e-18) << "no rounding away of a small turn";
}

TEST(MotionBounds, WithoutNumbersTurnAsFastAsTheJointsMayMove) {
    const PlatformGeometry machine = laboratory();
    const MotionBounds bounds = withDefaults(MotionBounds{}, machine);
    EXPECT_GT(bounds.legSpeed, 0.0);
    EXPECT_DOUBLE_EQ(bounds.speed, bounds.legSpeed);
    EXPECT_DOUBLE_EQ(bounds.angularSpeed * machine.jointRadius(), bounds.legSpeed);
}

TEST(StraightMotion, IsStraightTurnsAboutOneAxisAndKeepsItsLimits) {
    const PlatformGeometry machine = laboratory();
    const MotionBounds bounds = withDefaults(MotionBounds{}, machine);
    const Pose from = poseMm(-10, 5, -12, 4, -3, 2), to = poseMm(20, -14, 25, -6, 8, 15);
    const StraightMotion motion(PlatformModel(machine), from, to, bounds);
    expectConsistent(motion);
    const Twist way = displacement(from, to);
    double top = 0.0;
    LegLengths before = LegLengths::Zero();
    const double h = motion.duration() / kLooks;
    for (int i = 0; i <= kLooks; ++i) {
        const PoseReference at = motion.at(i * h);
        const Twist gone = displacement(from, at.pose);
        const double part = gone.head<3>().norm() / way.head<3>().norm();
        EXPECT_LT((gone - part * way).norm(), 1e-12);
        EXPECT_LE(at.twist.head<3>().norm(), bounds.speed * (1.0 + kBoundSlack));
        EXPECT_LE(at.twist.tail<3>().norm(), bounds.angularSpeed * (1.0 + kBoundSlack));
        const LegLengths rates = geometricJacobian(machine, at.pose) * at.twist;
        top = std::max(top, rates.cwiseAbs().maxCoeff());
        EXPECT_LE((rates - before).cwiseAbs().maxCoeff(), bounds.legAcceleration * h * (1.0 + kBoundSlack));
        before = rates;
    }
    EXPECT_LE(top, bounds.legSpeed * (1.0 + kBoundSlack));
    EXPECT_GT(top, 0.97 * bounds.legSpeed) << "one leg is at its limit: the way takes no longer than it must";
}

TEST(StraightMotion, SlowsDownWhereOnlyTheLegsAccelerationsAsk) {
    const PlatformGeometry machine = laboratory();
    MotionBounds bounds = withDefaults(MotionBounds{}, machine);
    bounds.legAcceleration *= 0.05; // far below what P's own acceleration makes of it
    const Pose from = poseMm(-10, 5, -12, 4, -3, 2), to = poseMm(20, -14, 25, -6, 8, 15);
    const StraightMotion motion(PlatformModel(machine), from, to, bounds);
    expectConsistent(motion);
    double largest = 0.0;
    LegLengths before = LegLengths::Zero();
    const double h = motion.duration() / kLooks;
    for (int i = 0; i <= kLooks; ++i) {
        const PoseReference at = motion.at(i * h);
        const LegLengths rates = geometricJacobian(machine, at.pose) * at.twist;
        largest = std::max(largest, (rates - before).cwiseAbs().maxCoeff() / h);
        before = rates;
    }
    EXPECT_LE(largest, bounds.legAcceleration * (1.0 + kBoundSlack));
    EXPECT_GT(largest, 0.9 * bounds.legAcceleration) << "no slower than that";
}

TEST(StraightMotion, IsTheFastestUnderItsLimits) {
    const PlatformGeometry machine = laboratory();
    MotionBounds bounds = withDefaults(MotionBounds{}, machine);
    bounds.legSpeed = bounds.legAcceleration = 1e3; // only P's limits count
    const Pose to = poseMm(0, 0, 20, 0, 0, 0);
    const StraightMotion motion(PlatformModel(machine), Pose{}, to, bounds);
    const double v = bounds.speed, a = bounds.acceleration, j = bounds.jerk, length = 0.02;
    const double toSpeed = v / a + a / j;
    EXPECT_NEAR(motion.duration(), toSpeed + length / v, 1e-3) << "closed form of the seven-piece profile";
}

TEST(StraightMotion, OfNoLengthIsOverAtOnce) {
    const PlatformGeometry machine = laboratory();
    const Pose here = poseMm(3, 4, 5, 1, 2, 3);
    const StraightMotion motion(PlatformModel(machine), here, here, withDefaults(MotionBounds{}, machine));
    EXPECT_EQ(motion.duration(), 0.0);
    EXPECT_EQ(motion.at(0.0).pose.toVector(), here.toVector());
    EXPECT_EQ(motion.at(1.0).twist, Twist::Zero());
}

TEST(SineSweep, SwingsAlongItsAxisAndBeginsAndEndsAtRestAtTheCentre) {
    const Pose centre = poseMm(3, 4, 5, 1, 2, 3);
    for (int axis = 0; axis < 6; ++axis) {
        SCOPED_TRACE(axis);
        const double amplitude = axis < 3 ? 0.005 : 0.05;
        const SineSweep sweep(centre, {axis, amplitude, 0.2, 2.0, 8.0});
        expectConsistent(sweep);
        for (const double t : {0.0, 8.0, 9.0}) {
            EXPECT_LT(displacement(centre, sweep.at(t).pose).norm(), 1e-12);
            EXPECT_LT(sweep.at(t).twist.norm(), 1e-12);
        }
        double largest = 0.0;
        for (int i = 0; i <= kLooks; ++i) {
            Twist gone = displacement(centre, sweep.at(8.0 * i / kLooks).pose);
            largest = std::max(largest, std::abs(gone[axis]));
            gone[axis] = 0.0;
            EXPECT_LT(gone.norm(), 1e-12) << "nothing moves on the other axes";
        }
        EXPECT_NEAR(largest, amplitude, 0.01 * amplitude);
    }
    EXPECT_TRUE(faultOf({0, -1.0, 0.1, 1.0, 10.0}));
    EXPECT_TRUE(faultOf({6, 0.01, 0.1, 1.0, 10.0}));
    EXPECT_TRUE(faultOf({0, 0.01, -0.1, 1.0, 10.0}));
    EXPECT_TRUE(faultOf({0, 0.01, 0.1, 1.0, std::nan("")}));
    EXPECT_FALSE(faultOf({0, 0.01, 0.1, 1.0, 10.0}));
}

} // namespace
} // namespace hexapose
