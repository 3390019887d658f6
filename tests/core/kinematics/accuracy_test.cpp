// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/pose_accuracy.h"
#include "core/kinematics/singularity.h"
#include "test_machines.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace hexapose::testing {
namespace {

double turnBetween(const Pose& a, const Pose& b) {
    const Eigen::Matrix3d R = rotationMatrix(a.angles).transpose() * rotationMatrix(b.angles);
    // From the antisymmetric part: the trace tells nothing of small angles.
    return std::asin(
        std::min(1.0, 0.5 * Eigen::Vector3d(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)).norm()));
}

} // namespace

/// The exact pose is known, because the lengths were made from it; the computed one is stopped early, or is
/// the exact one with an error put in.
TEST(PoseAccuracy, TheExactPoseIsWithinTheBound) {
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric(),
                                            scaledBy(1e-3, laboratory()), scaledBy(1e3, asymmetric())}) {
        const PlatformModel model(machine);
        RandomPoses poses(0.1 * machine.size(), radiansFromDeg(25.0), 77), errors(machine.size(), 1.0, 78);
        for (const double error : {0.0, 1e-12, 1e-9, 1e-6, 1e-4, 2e-3}) {
            double tightest = 0.0;
            for (int i = 0; i < 200; ++i) {
                const Pose exact = poses.next();
                const Pose computed = Pose::fromVector(exact.toVector() + error * errors.next().toVector());
                const double residual = (legLengths(machine, computed) - legLengths(machine, exact)).norm();
                const PoseAccuracy accuracy = poseAccuracy(model, computed, residual);
                const double offset = (computed.offset - exact.offset).norm(),
                             turn = turnBetween(computed, exact);
                ASSERT_LE(offset, accuracy.offsetBound) << machine.name << " error " << error;
                ASSERT_LE(turn, accuracy.angleBound) << machine.name << " error " << error;
                if (error <= 1e-4) {
                    ASSERT_TRUE(std::isfinite(accuracy.offsetBound)) << machine.name << " error " << error;
                }
                tightest = std::max({tightest, offset / accuracy.offsetBound, turn / accuracy.angleBound});
            }
            if (error >= 1e-9 && error <= 1e-4) {
                EXPECT_GT(tightest, 0.2) << "a bound that is far too large says nothing";
            }
        }
    }
}

TEST(PoseAccuracy, HoldsForWhatNewtonStopsAt) {
    const PlatformGeometry machine = laboratory();
    const PlatformModel model(machine);
    for (const double tolerance : {1e-3, 1e-5, 1e-8, 1e-10}) {
        const NewtonRaphson newton(machine, {tolerance, 50});
        RandomPoses poses = publishedPoses(2, 5);
        for (int i = 0; i < 500; ++i) {
            const Pose exact = poses.next();
            const ForwardResult result = newton.solve(legLengths(machine, exact), Pose{});
            ASSERT_EQ(result.status, SolveStatus::Converged);
            const PoseAccuracy accuracy = poseAccuracy(model, result.pose, result.residual);
            ASSERT_LE((result.pose.offset - exact.offset).norm(), accuracy.offsetBound);
            ASSERT_LE(turnBetween(result.pose, exact), accuracy.angleBound);
        }
    }
}

TEST(PoseAccuracy, GivesNoBoundWhereThereIsNone) {
    const PlatformGeometry machine = laboratory();
    const PlatformModel model(machine);
    EXPECT_TRUE(std::isinf(poseAccuracy(model, Pose{}, 0.1).offsetBound));
    EXPECT_TRUE(std::isinf(poseAccuracy(PlatformModel(similarHexagons()), Pose{}, 1e-12).angleBound));
    const PoseAccuracy home = poseAccuracy(model, Pose{}, 0.0);
    EXPECT_NEAR(home.smallestSingularValue, singularityMeasure(machine, Pose{}).smallestSingularValue, 1e-15);
    EXPECT_LT(home.offsetBound, 1e-14);
}

/// Against what many roundings of the lengths really do.
TEST(RoundingEffect, IsTheSpreadOfRoundedLengths) {
    const PlatformGeometry machine = laboratory();
    const NewtonRaphson newton(machine, {});
    constexpr double kResolution = 1e-4;
    constexpr int kDraws = 4000;
    const Pose pose{{0.012, -0.004, 0.02}, {0.05, -0.1, 0.08}};
    const RoundingEffect effect = roundingEffect(machine, pose, kResolution);
    RandomPoses uniform(kResolution / 2.0, kResolution / 2.0, 12); // six independent numbers
    PoseVector square = PoseVector::Zero();
    for (int i = 0; i < kDraws; ++i) {
        const LegLengths lengths = legLengths(machine, pose) + uniform.next().toVector();
        const PoseVector error = newton.solve(lengths, pose).pose.toVector() - pose.toVector();
        square += error.cwiseAbs2();
        ASSERT_TRUE((error.cwiseAbs().array() <= 1.02 * effect.bound.array()).all());
    }
    for (int k = 0; k < 6; ++k)
        EXPECT_NEAR(std::sqrt(square[k] / kDraws) / effect.sigma[k], 1.0, 0.05) << k;
}

} // namespace hexapose::testing
