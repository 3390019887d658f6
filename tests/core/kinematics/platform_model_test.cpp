// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/platform_model.h"

#include "core/geometry/singular_values.h"
#include "core/kinematics/extreme_singular_values.h"
#include "core/kinematics/inverse_kinematics.h"
#include "test_machines.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace hexapose;
using namespace hexapose::testing;

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

Matrix6 randomMatrix(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    return Matrix6::NullaryExpr([&] { return unit(random); });
}

Matrix6 randomRotation(std::mt19937_64& random) {
    return Eigen::HouseholderQR<Matrix6>(randomMatrix(random)).householderQ();
}

void expectExtremes(const Matrix6& matrix, const Vector6& values) {
    const ExtremeSingularValues found = extremeSingularValues(matrix);
    EXPECT_NEAR(found.smallest, values.minCoeff(), 1e-12 * values.maxCoeff()) << values.transpose();
    EXPECT_NEAR(found.largest, values.maxCoeff(), 1e-12 * values.maxCoeff()) << values.transpose();
}

} // namespace

TEST(ExtremeSingularValues, AreThoseOfAllValues) {
    std::mt19937_64 random(4);
    for (int i = 0; i < 2000; ++i) {
        const Matrix6 matrix = randomMatrix(random);
        expectExtremes(matrix, singularValues(matrix));
    }
    expectExtremes(Matrix6::Identity(), Vector6::Ones());
    expectExtremes(Matrix6::Zero(), Vector6::Zero());
}

/// Two, three and more that are the same, or nearly so, at either end, down to a singular matrix: symmetric
/// machines have such.
TEST(ExtremeSingularValues, AreRightWhereSeveralAreNearlyTheSame) {
    std::mt19937_64 random(5);
    for (const double least : {1.0, 0.5, 0.1, 0.02, 6e-3, 5e-3, 1e-3, 1e-6, 1e-12, 0.0})
        for (const double gap : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2})
            for (int same = 1; same <= 6; ++same)
                for (int i = 0; i < 5; ++i) {
                    Vector6 values;
                    for (int k = 0; k < 6; ++k)
                        values[k] = k < same ? least * (1.0 + k * gap) : 1.0 + 0.3 * k;
                    expectExtremes(randomRotation(random) * values.asDiagonal() * randomRotation(random),
                                   values);
                    values = (2.0 + least) * Vector6::Ones() - values; // the cluster at the other end
                    expectExtremes(randomRotation(random) * values.asDiagonal() * randomRotation(random),
                                   values.cwiseAbs());
                }
}

/// Real machines do not take the decomposition, which lasts ten times as long.
TEST(ExtremeSingularValues, OfRealMachinesAreFoundFast) {
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric()}) {
        const LegEquations equations(machine);
        RandomPoses poses(0.13 * machine.size(), 0.35, 23);
        for (int i = 0; i < 500; ++i) {
            const Pose pose = i == 0 ? Pose{} : poses.next();
            const Matrix6 jacobian = equations.jacobian(
                equations.evaluate(equations.placementOf(pose), LegEquations::Legs::Zero()));
            EXPECT_TRUE(fastExtremeSingularValues(jacobian)) << machine.name << ' ' << i;
        }
    }
}

TEST(Determinant, IsThatOfTheFactorisation) {
    std::mt19937_64 random(6);
    for (int i = 0; i < 200; ++i) {
        const Matrix6 matrix = randomMatrix(random);
        EXPECT_NEAR(determinantOf(matrix), matrix.determinant(), 1e-14);
    }
    EXPECT_EQ(determinantOf(Matrix6::Identity()), 1.0);
}

TEST(PlatformModel, TellsWhatFollowsFromTheGeometry) {
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric()}) {
        const PlatformModel model(machine);
        EXPECT_EQ(model.size(), machine.size());
        EXPECT_EQ(model.jointRadius(), machine.jointRadius());
        EXPECT_EQ(model.fingerprint(), machine.fingerprint());
        EXPECT_NEAR(model.determinantRatio(Pose{}), 1.0, 1e-14);
        RandomPoses poses(0.2 * machine.size(), 0.5, 23);
        for (int i = 0; i < 50; ++i) {
            const Pose pose = poses.next();
            EXPECT_EQ(model.actuators(pose), legLengths(machine, pose));
            EXPECT_EQ(model.jacobian(pose), geometricJacobian(machine, pose));
            const Eigen::Matrix<double, 3, kLegCount> joints = model.joints(pose);
            for (int leg = 0; leg < kLegCount; ++leg)
                EXPECT_NEAR((joints.col(leg) - machine.legs[static_cast<std::size_t>(leg)].p_OA_B).norm(),
                            model.actuators(pose)[leg], 1e-14 * machine.size());
            // Moments about the joints' centroid, over their spread.
            Jacobian scaled = model.jacobian(pose);
            const Eigen::Vector3d centroid = joints.rowwise().mean() - machine.p_OP_home_B - pose.offset;
            for (int leg = 0; leg < kLegCount; ++leg) {
                const Eigen::Vector3d n = scaled.row(leg).head<3>();
                scaled.row(leg).tail<3>() -= centroid.cross(n);
            }
            const double spread = (joints.colwise() - joints.rowwise().mean()).norm() / std::sqrt(6.0);
            scaled.rightCols<3>() /= spread;
            const Vector6 values = singularValues(Matrix6(scaled));
            const SingularityMeasure measure = model.singularity(pose);
            EXPECT_NEAR(measure.smallestSingularValue, values[5], 1e-12 * values[0]);
            EXPECT_NEAR(measure.condition, values[0] / values[5], 1e-10 * values[0] / values[5]);
            EXPECT_NEAR(measure.determinant, scaled.determinant(), 1e-13);
            EXPECT_NEAR(model.determinantRatio(pose), scaled.determinant() / model.homeDeterminant(), 1e-12);
        }
        for (int leg = 0; leg < kLegCount; ++leg) {
            EXPECT_EQ(model.minActuators()[leg], machine.legs[static_cast<std::size_t>(leg)].minLength);
            EXPECT_EQ(model.maxActuators()[leg], machine.legs[static_cast<std::size_t>(leg)].maxLength);
        }
    }
}

TEST(PlatformModel, HasNoSideWhereItIsSingularAtHome) {
    const PlatformModel model(similarHexagons());
    EXPECT_EQ(model.homeDeterminant(), 0.0);
    EXPECT_TRUE(std::isnan(model.determinantRatio({Eigen::Vector3d::Zero(), {0.1, 0.2, 0.3}})));
    EXPECT_EQ(PlatformModel(laboratory()).singularity({{1e200, 0.0, 0.0}, {}}).smallestSingularValue, 0.0);
}
