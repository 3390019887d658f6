// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// A converged pose is on home's side of the singular surface, and joined to home.
#include "core/kinematics/jacobian.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/singular_home.h"
#include "core/kinematics/singularity.h"
#include "test_machines.h"
#include "tests/support/sample_count.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace hexapose::testing {
namespace {

using testing_support::samples;

double determinantRatio(const PlatformGeometry& machine, const Pose& pose) {
    return singularityMeasure(machine, pose).determinant / singularityMeasure(machine, Pose{}).determinant;
}

/// Along the straight path from home: the origin on a line, one axis of rotation. Far finer than the solver
/// looks.
bool isStraightWayFree(const PlatformGeometry& machine, const Pose& pose) {
    const Eigen::AngleAxisd turn(rotationMatrix(pose.angles));
    for (int i = 0; i <= 400; ++i) {
        const double part = i / 400.0;
        const Eigen::Matrix3d R = Eigen::AngleAxisd(part * turn.angle(), turn.axis()).toRotationMatrix();
        if (!(determinantRatio(machine, {part * pose.offset, eulerAngles(R)}) > 0.0))
            return false;
    }
    return true;
}

/// Along the straight path of the legs, by Newton with the analytic Jacobian in many small steps.
bool isWayOfTheLegsFree(const PlatformGeometry& machine, const Pose& pose) {
    const LegLengths first = legLengths(machine, Pose{}), last = legLengths(machine, pose);
    PoseVector x = PoseVector::Zero();
    for (int i = 1; i <= 2000; ++i) {
        const LegLengths target = first + (last - first) * (i / 2000.0);
        for (int k = 0; k < 4; ++k) {
            const Pose at = Pose::fromVector(x);
            if (!(determinantRatio(machine, at) > 0.0))
                return false;
            x += analyticJacobian(machine, at).partialPivLu().solve(target - legLengths(machine, at));
        }
    }
    return distance(machine, Pose::fromVector(x), pose) < 1e-6;
}

struct Wide {
    double mm, deg, leastRight;
    int count;
};

} // namespace

TEST(SingularHome, IsNamedWithItsLikelyCause) {
    for (const PlatformGeometry& machine :
         {laboratory(), octahedral(), asymmetric(), scaledBy(1e-3, laboratory())})
        EXPECT_FALSE(faultOfHome(machine)) << machine.name;
    EXPECT_EQ(faultOfHome(similarHexagons()).value_or(""),
              "its geometry is singular at home: base and platform joints form similar figures");
    PlatformGeometry inches = laboratory();
    for (Leg& leg : inches.legs) {
        leg.p_OA_B /= 25.4;
        leg.p_PB_P /= 25.4;
    }
    EXPECT_EQ(
        faultOfHome(inches).value_or(""),
        "its geometry is too close to singular at home; likely cause: base_mm and platform_mm are in inches");
}

TEST(Side, WidePosesAreRightOrSaySoOrAreJoinedToHome) {
    const PlatformGeometry machine = laboratory();
    const NewtonRaphson newton(machine, {});
    for (const Wide& wide :
         {Wide{60.0, 60.0, 0.999, samples(4000)}, Wide{80.0, 75.0, 0.993, samples(4000)}}) {
        RandomPoses poses(metresFromMm(wide.mm), radiansFromDeg(wide.deg), 20230382);
        int onSide = 0, right = 0;
        for (int i = 0; i < wide.count; ++i) {
            const Pose truth = poses.next();
            const ForwardResult result = newton.solve(legLengths(machine, truth), Pose{});
            const bool found = result.isUsable() && distance(machine, result.pose, truth) < 1e-6;
            if (determinantRatio(machine, truth) > 0.0) {
                ++onSide;
                right += found;
            }
            if (!result.isUsable()) {
                EXPECT_NE(result.status, SolveStatus::Converged);
                continue;
            }
            EXPECT_GT(determinantRatio(machine, result.pose), 0.0);
            if (!found) {
                EXPECT_TRUE(isStraightWayFree(machine, result.pose) ||
                            isWayOfTheLegsFree(machine, result.pose))
                    << wide.mm << " mm, pose " << i;
            }
        }
        EXPECT_GE(right, wide.leastRight * onSide) << right << " of " << onSide << " at " << wide.mm << " mm";
    }
}

/// Two minutes and three quarters of motion at 100 Hz, a hundred times over.
TEST(Side, AStreamNeverChangesItsBranch) {
    constexpr int kFrames = samples(1000000);
    constexpr double kResolution = 1e-4;
    const PlatformGeometry machine = laboratory();
    const NewtonRaphson newton(machine, {});
    for (const double resolution : {0.0, kResolution}) {
        Pose previous;
        int wrong = 0;
        const int frames = resolution > 0.0 ? kFrames : kFrames / 10;
        for (int i = 0; i < frames; ++i) {
            const double t = 0.01 * i;
            PoseVector x;
            for (int k = 0; k < 6; ++k)
                x[k] = (k < 3 ? 0.028 : radiansFromDeg(28.0)) * std::sin((0.9 + 0.37 * k) * t + k * 1e-3 * t);
            LegLengths lengths = legLengths(machine, Pose::fromVector(x));
            if (resolution > 0.0)
                lengths = (lengths / resolution).array().round() * resolution;
            const ForwardResult result = newton.solve(lengths, previous);
            // Rounding moves the pose by well under a millimetre and half a degree here.
            if (!result.isUsable() || distance(machine, result.pose, Pose::fromVector(x)) > 0.02)
                ++wrong;
            previous = result.pose;
        }
        EXPECT_EQ(wrong, 0) << "resolution " << resolution;
    }
}

} // namespace hexapose::testing
