// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/rigid_fit.h"

#include <Eigen/Core>

namespace hexapose {

/// How far a computed pose is from the true one (Front. Mech. Eng. 2025, 20(1):7, Eq. 18 and Fig. 11).
struct PoseErrors {
    Eigen::Vector3d posture;  ///< angle between the computed and the true x, y and z axis, rad
    Eigen::Vector3d position; ///< computed minus true origin, base frame, m
    double turn;              ///< angle of the rotation from one to the other, rad
};
PoseErrors poseErrors(const BodyMotion& computed, const BodyMotion& exact) noexcept;

/// The vector, rad, of the rotation from `from` to `to`, base frame. Good to the last digit for small ones.
Eigen::Vector3d rotationVector(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) noexcept;

} // namespace hexapose
