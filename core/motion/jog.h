// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/pose.h"
#include "core/geometry/twist.h"

namespace hexapose {

enum class JogFrame { Base, Platform };

/// Along or about one axis of a frame.
struct JogDirection {
    int axis = 0;   ///< 0..2: along x, y, z; 3..5: about x, y, z
    bool up = true; ///< towards larger values
    JogFrame frame = JogFrame::Base;
    bool operator==(const JogDirection&) const = default;
};

/// The unit twist of a direction at a pose, base frame: 1 m/s along, or 1 rad/s about it through P.
Twist unitTwist(const JogDirection& direction, const Pose& pose);

/// The pose a step further: step in m or rad.
Pose stepped(const Pose& pose, const JogDirection& direction, double step);

} // namespace hexapose
