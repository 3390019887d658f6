// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/inverse_kinematics.h"

namespace hexapose {

LegLengths legLengths(const PlatformGeometry& geometry, const Pose& pose) {
    const Eigen::Matrix3d R = rotationMatrix(pose.angles);
    const Eigen::Vector3d origin = geometry.p_OP_home_B + pose.offset;
    LegLengths lengths;
    for (int i = 0; i < kLegCount; ++i) {
        const Leg& leg = geometry.legs[static_cast<std::size_t>(i)];
        lengths[i] = (origin + R * leg.p_PB_P - leg.p_OA_B).norm();
    }
    return lengths;
}

} // namespace hexapose
