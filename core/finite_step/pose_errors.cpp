// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/pose_errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

/// From the chord of two unit vectors, which keeps its digits where the arc cosine loses them.
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept {
    return 2.0 * std::asin(std::min(1.0, 0.5 * (a - b).norm()));
}

} // namespace

Eigen::Vector3d rotationVector(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) noexcept {
    const Eigen::AngleAxisd turn(Eigen::Quaterniond(Eigen::Matrix3d(to * from.transpose())));
    return turn.angle() * turn.axis();
}

PoseErrors poseErrors(const BodyMotion& computed, const BodyMotion& exact) noexcept {
    PoseErrors errors;
    for (Eigen::Index k = 0; k < 3; ++k)
        errors.posture[k] = angleBetween(computed.R_BP.col(k), exact.R_BP.col(k));
    errors.position = computed.p_OP_B - exact.p_OP_B;
    errors.turn = rotationVector(exact.R_BP, computed.R_BP).norm();
    return errors;
}

} // namespace hexapose
