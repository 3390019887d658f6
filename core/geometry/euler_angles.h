// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace hexapose {

/// Rotation of the platform against the base, radians: R_BP = Rz(gamma) Ry(beta) Rx(alpha)
/// (Applied Sciences 2023, 13, 3082, Eq. 2).
struct EulerAngles {
    double alpha = 0.0; ///< about x
    double beta = 0.0;  ///< about y
    double gamma = 0.0; ///< about z
};

/// R_BP (Eq. 2), 3x3: turns platform-frame vectors into the base frame. Not finite where an angle is not.
Eigen::Matrix3d rotationMatrix(const EulerAngles& angles);

/// The angles of a rotation matrix: alpha and gamma in (-pi, pi], beta in [-pi/2, pi/2]. At beta = +-pi/2
/// (gimbal lock) alpha is set to 0. That R_BP is a rotation is not checked.
EulerAngles eulerAngles(const Eigen::Matrix3d& R_BP);

/// E(angles), 3x3, with omega_B = E * (alpha', beta', gamma'), both in rad/s: the Euler-rate matrix, base
/// frame, for the rotation of Eq. 2. Singular at beta = +-pi/2.
Eigen::Matrix3d eulerRateMatrix(const EulerAngles& angles);

} // namespace hexapose
