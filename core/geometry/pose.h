// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/euler_angles.h"

#include <Eigen/Core>

namespace hexapose {

/// 6x1: x y z (m), alpha beta gamma (rad), the order of every six-vector of pose coordinates.
using PoseVector = Eigen::Matrix<double, 6, 1>;

/// Where the platform is: displacement of the platform origin P from its home position, base frame, metres,
/// and the rotation of the platform against the base (Eq. 2). Pose{} is home.
struct Pose {
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    EulerAngles angles;

    PoseVector toVector() const {
        PoseVector v;
        v << offset, angles.alpha, angles.beta, angles.gamma;
        return v;
    }
    static Pose fromVector(const PoseVector& v) { return {v.head<3>(), {v[3], v[4], v[5]}}; }
    bool isFinite() const { return toVector().allFinite(); }
};

} // namespace hexapose
