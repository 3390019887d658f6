// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/kinematics/forward_solver.h"

#include <cmath>
#include <limits>

namespace hexapose {

/// Residual of a solution that has none.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Lengths that can be the lengths of legs: finite and positive.
inline bool areValidLengths(const LegLengths& lengths) noexcept {
    return lengths.allFinite() && (lengths.array() > 0.0).all();
}

/// A result without a pose: NaN, so that nobody takes it for home.
inline ForwardResult failure(SolveStatus status, int iterations, double residual) noexcept {
    ForwardResult result;
    result.pose = Pose::fromVector(PoseVector::Constant(std::numeric_limits<double>::quiet_NaN()));
    result.status = status;
    result.iterations = iterations;
    result.residual = residual;
    return result;
}

/// What the sign of the Jacobian's determinant at a converged pose (0: singular there) means beside home's.
inline SolveStatus branchStatus(double sign, double homeDeterminant) noexcept {
    if (sign == 0.0)
        return SolveStatus::Singular;
    return sign * homeDeterminant < 0.0 ? SolveStatus::OtherBranch : SolveStatus::Converged;
}

/// Norm of the six leg errors at a pose, m, also where its square would overflow.
double legResidual(const PlatformGeometry& geometry, const LegLengths& lengths, const Pose& pose) noexcept;

/// Angles in the ranges of eulerAngles(); a rotation by them is the same.
Pose normalised(const Pose& pose) noexcept;

} // namespace hexapose
