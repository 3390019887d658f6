// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"

#include <Eigen/Core>

namespace hexapose {

/// 6x6. Rows are legs, columns coordinates. A leg of length zero has no direction: its row is zeros.
using Jacobian = Eigen::Matrix<double, kLegCount, 6>;

/// Leg rates from the twist of the platform: l' = J (v, omega), row i = [n_i^T, (R b_i x n_i)^T] (Eq. 8), v
/// and omega in the base frame (m/s, rad/s), v that of the platform origin P. Columns 1 to 3 without unit, 4
/// to 6 in m.
Jacobian geometricJacobian(const PlatformGeometry& geometry, const Pose& pose);

/// Leg rates from the rates of the pose coordinates: dl/d(x y z alpha beta gamma); the exact derivative of
/// legLengths(), and the geometric one with its last three columns times eulerRateMatrix(). Units as there.
/// Singular at gimbal lock too.
Jacobian analyticJacobian(const PlatformGeometry& geometry, const Pose& pose);

} // namespace hexapose
