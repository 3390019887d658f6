// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/jacobian.h"

#include <Eigen/LU>

namespace hexapose::bench {

/// What anybody would write with Eigen in an afternoon: Newton on x y z alpha beta gamma with the Euler-rate
/// matrix, PartialPivLU, fixed sizes; no guard, no branch, no status. Every figure is to be read against it.
inline int plainNewton(const PlatformGeometry& geometry, const LegLengths& lengths, Pose& pose,
                       double tolerance) {
    PoseVector x = pose.toVector();
    for (int iteration = 0; iteration < 50; ++iteration) {
        const Eigen::Matrix3d R = rotationMatrix({x[3], x[4], x[5]});
        const Eigen::Vector3d origin = geometry.p_OP_home_B + x.head<3>();
        Jacobian J;
        LegVector error;
        for (int i = 0; i < kLegCount; ++i) {
            const Leg& leg = geometry.legs[static_cast<std::size_t>(i)];
            const Eigen::Vector3d arm = R * leg.p_PB_P;
            const Eigen::Vector3d d = origin + arm - leg.p_OA_B;
            const double length = d.norm();
            const Eigen::Vector3d n = d / length;
            J.row(i) << n.transpose(), arm.cross(n).transpose();
            error[i] = lengths[i] - length;
        }
        if (error.norm() <= tolerance) {
            pose = Pose::fromVector(x);
            return iteration;
        }
        J.rightCols<3>() = (J.rightCols<3>() * eulerRateMatrix({x[3], x[4], x[5]})).eval();
        x += Eigen::PartialPivLU<Jacobian>(J).solve(error);
    }
    return -1;
}

} // namespace hexapose::bench
