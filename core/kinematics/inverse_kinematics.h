// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"

namespace hexapose {

/// l_i = | p_home + p + R b_i - A_i |, metres (Eq. 3). Exact for every finite
/// pose, not finite for others; knows nothing of strokes.
LegLengths legLengths(const PlatformGeometry& geometry, const Pose& pose);

} // namespace hexapose
