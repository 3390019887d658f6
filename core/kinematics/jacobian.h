// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"

#include <Eigen/Core>

namespace hexapose {

/// Rows are legs, columns coordinates.
using Jacobian = Eigen::Matrix<double, kLegCount, 6>;

/// Leg rates from the twist of the platform: l' = J (v, omega), row i = [n_i^T, (R b_i x n_i)^T] (Eq. 8), v
/// and omega in the base frame (m/s, rad/s), v that of the platform origin P.
Jacobian geometricJacobian(const PlatformGeometry& geometry, const Pose& pose);

/// Leg rates from the rates of the pose coordinates: dl/d(x y z alpha beta gamma); the exact derivative of
/// legLengths().
Jacobian analyticJacobian(const PlatformGeometry& geometry, const Pose& pose);

} // namespace hexapose
