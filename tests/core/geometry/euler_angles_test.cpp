// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/geometry/euler_angles.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace hexapose;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-14;

Eigen::Matrix3d byAxes(const EulerAngles& angles) {
    return (Eigen::AngleAxisd(angles.gamma, Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(angles.beta, Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(angles.alpha, Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
}

} // namespace

TEST(EulerAngles, GiveTheProductOfTheThreeTurnsAndComeBack) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> turn(-kPi, kPi);
    for (int i = 0; i < 1000; ++i) {
        const EulerAngles angles{turn(random), 0.499 * turn(random), turn(random)};
        const Eigen::Matrix3d R = rotationMatrix(angles);
        EXPECT_LT((R - byAxes(angles)).norm(), kRounding);
        const EulerAngles back = eulerAngles(R);
        EXPECT_NEAR(back.alpha, angles.alpha, 1e-10);
        EXPECT_NEAR(back.beta, angles.beta, 1e-10);
        EXPECT_NEAR(back.gamma, angles.gamma, 1e-10);
    }
}

TEST(EulerAngles, GiveTheSameRotationAtAndNextToGimbalLock) {
    for (const double sign : {-1.0, 1.0})
        for (const double away : {0.0, 1e-16, 1e-13, 1e-10, 1e-8, 1e-5}) {
            const Eigen::Matrix3d R = rotationMatrix({0.7, sign * (kPi / 2 - away), -2.1});
            const EulerAngles angles = eulerAngles(R);
            EXPECT_LT((rotationMatrix(angles) - R).norm(), 1e-13) << away;
            EXPECT_LE(std::abs(angles.beta), kPi / 2);
        }
    EXPECT_EQ(eulerAngles(rotationMatrix({0.3, kPi / 2, 0.5})).alpha, 0.0);
}

TEST(EulerAngles, HalfTurnsComeOutAsPlusPi) {
    Eigen::Matrix3d aboutZ = Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();
    aboutZ(1, 0) = -0.0;
    EXPECT_EQ(eulerAngles(aboutZ).gamma, kPi);
    Eigen::Matrix3d aboutX = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
    aboutX(2, 1) = aboutX(1, 2) = -0.0;
    EXPECT_EQ(eulerAngles(aboutX).alpha, kPi);
}

TEST(EulerAngles, RateMatrixIsTheDerivativeOfTheRotation) {
    const EulerAngles at{0.4, -0.8, 1.9};
    const double h = 1e-6;
    for (int k = 0; k < 3; ++k) {
        EulerAngles plus = at, minus = at;
        double EulerAngles::*const angle =
            k == 0 ? &EulerAngles::alpha : (k == 1 ? &EulerAngles::beta : &EulerAngles::gamma);
        plus.*angle += h;
        minus.*angle -= h;
        const Eigen::Matrix3d spin =
            (rotationMatrix(plus) - rotationMatrix(minus)) / (2 * h) * rotationMatrix(at).transpose();
        const Eigen::Vector3d omega(spin(2, 1), spin(0, 2), spin(1, 0));
        EXPECT_LT((omega - eulerRateMatrix(at).col(k)).norm(), 1e-9);
    }
}
