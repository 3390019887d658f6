// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/limits.h"

#include <optional>
#include <utility>

namespace hexapose {

/// How far one coordinate (0..5) can go from a pose with the others held, as coordinates (m or rad); nothing
/// when the pose itself is out of the limits.
std::optional<std::pair<double, double>>
axisRange(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& pose, int coordinate);

} // namespace hexapose
