// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"

#include <cmath>

namespace hexapose::testing_support {

/// A small platform with a different stroke a leg: 190..310 mm for leg 1, each next leg 1 mm more at the end.
inline PlatformGeometry testPlatform() {
    PlatformGeometry geometry;
    geometry.name = "test";
    geometry.p_OP_home_B = {0.0, 0.0, 0.24};
    for (int leg = 0; leg < kLegCount; ++leg) {
        const double angle = leg * 1.0471975511965976;
        Leg& l = geometry.legs[static_cast<std::size_t>(leg)];
        l.p_OA_B = {0.15 * std::cos(angle), 0.15 * std::sin(angle), 0.0};
        l.p_PB_P = {0.10 * std::cos(angle + 0.3), 0.10 * std::sin(angle + 0.3), 0.0};
        l.minLength = 0.190;
        l.maxLength = 0.310 + 0.001 * leg;
    }
    return geometry;
}

} // namespace hexapose::testing_support
