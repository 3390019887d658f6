// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"

#include <Eigen/Core>

namespace hexapose {

/// How far a pose is from a singular one. All without units, and independent of where the platform origin P
/// was put: moments in the geometric Jacobian are taken about the centroid of the platform joints and divided
/// by their root mean square distance from it.
struct SingularityMeasure {
    double determinant = 0.0;           ///< of the scaled Jacobian, signed
    double smallestSingularValue = 0.0; ///< 0 is singular; 0.69 at home of the laboratory platform
    double condition = 0.0;             ///< largest over smallest singular value
};

/// Smallest singular value below which a pose counts as singular: there a leg error is magnified ten thousand
/// times, and the lengths no longer determine the pose.
inline constexpr double kSingularValueFloor = 1e-4;

/// From the scaled Jacobian. Where that is not finite: zeros, and an infinite condition. Takes 0.5 us.
SingularityMeasure singularityOf(const Eigen::Matrix<double, 6, 6>& scaledJacobian) noexcept;

/// At a finite pose. Builds a PlatformModel for it: callers that need it more than once keep one.
SingularityMeasure singularityMeasure(const PlatformGeometry& geometry, const Pose& pose);

/// Its determinant alone: without pivots, and so without branches.
double determinantOf(const Eigen::Matrix<double, 6, 6>& matrix) noexcept;

} // namespace hexapose
