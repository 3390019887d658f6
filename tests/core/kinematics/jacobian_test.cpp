// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/jacobian.h"

#include "core/kinematics/singularity.h"
#include "test_machines.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace hexapose;
using namespace hexapose::testing;

TEST(Jacobian, AnalyticIsTheDerivativeOfTheLengths) {
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric()}) {
        RandomPoses poses(0.2 * machine.size(), 1.0, 21);
        for (int i = 0; i < 50; ++i) {
            const PoseVector at = poses.next().toVector();
            const Jacobian J = analyticJacobian(machine, Pose::fromVector(at));
            for (int k = 0; k < 6; ++k) {
                const double h = 1e-5 * (k < 3 ? machine.size() : 1.0);
                const PoseVector step = h * PoseVector::Unit(k);
                const LegVector slope = (legLengths(machine, Pose::fromVector(at + step)) -
                                         legLengths(machine, Pose::fromVector(at - step))) /
                                        (2.0 * h);
                EXPECT_LT((slope - J.col(k)).norm(), 1e-8 * (k < 3 ? 1.0 : machine.size()))
                    << machine.name << k;
            }
        }
    }
}

TEST(Jacobian, GeometricMapsTheTwistOfARigidMotion) {
    const PlatformGeometry machine = asymmetric();
    RandomPoses poses(0.3, 1.0, 22);
    for (int i = 0; i < 20; ++i) {
        const Pose pose = poses.next();
        const PoseVector twist = poses.next().toVector();
        const Eigen::Matrix3d R = rotationMatrix(pose.angles);
        const auto lengthAt = [&](double t, std::size_t leg) { // the platform after a time t of this twist
            const Eigen::Vector3d omega = twist.tail<3>();
            const Eigen::Matrix3d turned = Eigen::AngleAxisd(t * omega.norm(), omega.normalized()) * R;
            return (machine.p_OP_home_B + pose.offset + t * twist.head<3>() +
                    turned * machine.legs[leg].p_PB_P - machine.legs[leg].p_OA_B)
                .norm();
        };
        const LegVector rates = geometricJacobian(machine, pose) * twist;
        for (std::size_t leg = 0; leg < kLegCount; ++leg)
            EXPECT_NEAR((lengthAt(1e-5, leg) - lengthAt(-1e-5, leg)) / 2e-5, rates[static_cast<int>(leg)],
                        1e-8);
    }
}

TEST(Singularity, KnowsTheLaboratoryPlatform) {
    const SingularityMeasure home = singularityMeasure(laboratory(), Pose{});
    EXPECT_NEAR(home.determinant, 2.677613, 1e-6);
    EXPECT_NEAR(home.smallestSingularValue, 0.69462, 1e-5);
    EXPECT_NEAR(home.condition, 3.2087, 1e-4);
    // Level poses are singular exactly at a quarter turn; the determinant changes its sign there.
    const auto atYaw = [](double deg) {
        return singularityMeasure(laboratory(), {Eigen::Vector3d::Zero(), {0.0, 0.0, radiansFromDeg(deg)}});
    };
    EXPECT_LT(atYaw(90.0).smallestSingularValue, 1e-12);
    EXPECT_GT(atYaw(89.0).determinant, 0.0);
    EXPECT_LT(atYaw(91.0).determinant, 0.0);
    EXPECT_LT(singularityMeasure(similarHexagons(), Pose{}).smallestSingularValue, 1e-12);
}

TEST(Singularity, DependsNeitherOnTheSizeNorOnTheOriginOfThePlatform) {
    const PlatformGeometry machine = asymmetric();
    PlatformGeometry moved = machine;
    const Eigen::Vector3d shift(0.4, -0.2, 0.7);
    moved.p_OP_home_B += shift;
    for (Leg& leg : moved.legs)
        leg.p_PB_P -= shift;
    const SingularityMeasure here = singularityMeasure(machine, Pose{});
    for (const SingularityMeasure& there :
         {singularityMeasure(moved, Pose{}), singularityMeasure(scaledBy(1e6, machine), Pose{})}) {
        EXPECT_NEAR(there.determinant, here.determinant, 1e-12);
        EXPECT_NEAR(there.condition, here.condition, 1e-10);
    }
}
