// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"

namespace hexapose {

/// How far a pose is from a singular one. All without units: the rotation columns of the geometric Jacobian are
/// divided by the joint radius.
struct SingularityMeasure {
    double determinant = 0.0;           ///< of the scaled Jacobian, signed
    double smallestSingularValue = 0.0; ///< 0 is singular; 0.69 at home of the laboratory platform
    double condition = 0.0;             ///< largest over smallest singular value
};

SingularityMeasure singularityMeasure(const PlatformGeometry& geometry, const Pose& pose);

} // namespace hexapose
