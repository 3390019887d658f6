// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/pose.h"

#include <Eigen/Core>

namespace hexapose {

/// 6x1: velocity of the platform origin P (m/s), then angular velocity (rad/s), both in the base frame: what
/// geometricJacobian() turns into leg rates. Over a time it is a displacement: m, and a rotation vector in
/// rad.
using Twist = Eigen::Matrix<double, 6, 1>;

/// The rotation about `vector`'s direction by its length, 3x3 (Rodrigues).
Eigen::Matrix3d rotationOf(const Eigen::Vector3d& vector);

/// The shortest displacement that leads from one pose to another: straight in position, and about one
/// axis fixed in the base frame by at most pi. displaced(from, displacement(from, to)) is `to`.
Twist displacement(const Pose& from, const Pose& to);

/// The pose after a displacement: position added, rotation put in front (base frame). Angles in the ranges of
/// eulerAngles().
Pose displaced(const Pose& pose, const Twist& displacement);

} // namespace hexapose
