// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/jacobian.h"

#include <Eigen/Geometry>

namespace hexapose {

Jacobian geometricJacobian(const PlatformGeometry& geometry, const Pose& pose) {
    const Eigen::Matrix3d R = rotationMatrix(pose.angles);
    const Eigen::Vector3d origin = geometry.p_OP_home_B + pose.offset;
    Jacobian J;
    for (int i = 0; i < kLegCount; ++i) {
        const Leg& leg = geometry.legs[static_cast<std::size_t>(i)];
        const Eigen::Vector3d arm = R * leg.p_PB_P;
        const Eigen::Vector3d direction = (origin + arm - leg.p_OA_B).normalized();
        J.row(i) << direction.transpose(), arm.cross(direction).transpose();
    }
    return J;
}

Jacobian analyticJacobian(const PlatformGeometry& geometry, const Pose& pose) {
    Jacobian J = geometricJacobian(geometry, pose);
    J.rightCols<3>() = (J.rightCols<3>() * eulerRateMatrix(pose.angles)).eval();
    return J;
}

} // namespace hexapose
