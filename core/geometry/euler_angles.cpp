// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/geometry/euler_angles.h"

#include <cmath>
#include <numbers>

namespace hexapose {

namespace {

/// atan2 gives -pi for (-0, negative); the range here is (-pi, pi].
double angleOf(double sine, double cosine) {
    const double angle = std::atan2(sine, cosine);
    return angle == -std::numbers::pi ? std::numbers::pi : angle;
}

/// cos(beta) below which alpha and gamma cannot be told apart.
constexpr double kGimbalLock = 1e-14;

} // namespace

Eigen::Matrix3d rotationMatrix(const EulerAngles& angles) {
    const double ca = std::cos(angles.alpha), sa = std::sin(angles.alpha);
    const double cb = std::cos(angles.beta), sb = std::sin(angles.beta);
    const double cg = std::cos(angles.gamma), sg = std::sin(angles.gamma);
    Eigen::Matrix3d R;
    R << cg * cb, cg * sb * sa - sg * ca, cg * sb * ca + sg * sa, //
        sg * cb, sg * sb * sa + cg * ca, sg * sb * ca - cg * sa,  //
        -sb, cb * sa, cb * ca;
    return R;
}

EulerAngles eulerAngles(const Eigen::Matrix3d& R_BP) {
    const auto& R = R_BP;
    const double cosBeta = std::sqrt(R(0, 0) * R(0, 0) + R(1, 0) * R(1, 0));
    const double beta = std::atan2(-R(2, 0), cosBeta);
    if (cosBeta < kGimbalLock)
        return {0.0, beta, angleOf(-R(0, 1), R(1, 1))};
    // alpha comes from Rz(gamma)^T R, not from the last row: next to gimbal lock the rounding of gamma then
    // cancels in the product, and the angles still give R back.
    const double cg = R(0, 0) / cosBeta, sg = R(1, 0) / cosBeta;
    return {angleOf(sg * R(0, 2) - cg * R(1, 2), cg * R(1, 1) - sg * R(0, 1)), beta,
            angleOf(R(1, 0), R(0, 0))};
}

Eigen::Matrix3d eulerRateMatrix(const EulerAngles& angles) {
    const double cb = std::cos(angles.beta), sb = std::sin(angles.beta);
    const double cg = std::cos(angles.gamma), sg = std::sin(angles.gamma);
    Eigen::Matrix3d E;
    E << cg * cb, -sg, 0.0, //
        sg * cb, cg, 0.0,   //
        -sb, 0.0, 1.0;
    return E;
}

} // namespace hexapose
