// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/jog.h"

namespace hexapose {

Twist unitTwist(const JogDirection& direction, const Pose& pose) {
    Eigen::Vector3d axis = Eigen::Vector3d::Unit(direction.axis % 3);
    if (direction.frame == JogFrame::Platform)
        axis = rotationMatrix(pose.angles) * axis;
    if (!direction.up)
        axis = -axis;
    Twist twist = Twist::Zero();
    twist.segment<3>(direction.axis < 3 ? 0 : 3) = axis;
    return twist;
}

Pose stepped(const Pose& pose, const JogDirection& direction, double step) {
    return displaced(pose, step * unitTwist(direction, pose));
}

} // namespace hexapose
