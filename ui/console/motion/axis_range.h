// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/machine/control_options.h"
#include "core/motion/jog.h"

#include <optional>
#include <utility>

namespace hexapose {

/// How far one coordinate (0..5) can go from a pose with the others held, as coordinates (m or rad): to a
/// stroke, the envelope or the singularity margin, whichever comes first. Nothing when the pose itself is out
/// of the limits.
std::optional<std::pair<double, double>> axisRange(const MotionPlanner& planner, const Pose& pose,
                                                   int coordinate);

/// How far (m or rad, not below 0) a jog can go in a direction from a pose, to the same limits; nothing when
/// the pose itself is out of them.
std::optional<double> jogRange(const MotionPlanner& planner, const Pose& pose, const JogDirection& direction);

} // namespace hexapose
