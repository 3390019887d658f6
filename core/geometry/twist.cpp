// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/geometry/twist.h"

#include <Eigen/Geometry>

#include <cmath>

namespace hexapose {

Eigen::Matrix3d rotationOf(const Eigen::Vector3d& vector) {
    const double angle = vector.norm();
    if (angle == 0.0)
        return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

Twist displacement(const Pose& from, const Pose& to) {
    // By way of a quaternion: exact for small angles too, and defined at half a turn.
    Eigen::Quaterniond turn(rotationMatrix(to.angles) * rotationMatrix(from.angles).transpose());
    if (turn.w() < 0.0)
        turn.coeffs() = -turn.coeffs();
    const double sine = turn.vec().norm();
    const double scale = sine > 0.0 ? 2.0 * std::atan2(sine, turn.w()) / sine : 2.0;
    Twist result;
    result << to.offset - from.offset, scale * turn.vec();
    return result;
}

Pose displaced(const Pose& pose, const Twist& displacement) {
    const Eigen::Matrix3d R_BP = rotationOf(displacement.tail<3>()) * rotationMatrix(pose.angles);
    return {pose.offset + displacement.head<3>(), eulerAngles(R_BP)};
}

} // namespace hexapose
