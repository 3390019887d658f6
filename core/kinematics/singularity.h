// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"

namespace hexapose {

/// How far a pose is from a singular one. All without units, and independent of where the platform origin P
/// was put: moments in the geometric Jacobian are taken about the centroid of the platform joints and divided
/// by their root mean square distance from it.
struct SingularityMeasure {
    double determinant = 0.0;           ///< of the scaled Jacobian, signed
    double smallestSingularValue = 0.0; ///< 0 is singular; 0.69 at home of the laboratory platform
    double condition = 0.0;             ///< largest over smallest singular value
};

/// At a finite pose. Where the Jacobian (Eq. 8) is not finite: zeros, and an infinite condition.
SingularityMeasure singularityMeasure(const PlatformGeometry& geometry, const Pose& pose);

} // namespace hexapose
