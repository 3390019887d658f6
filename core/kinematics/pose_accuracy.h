// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/platform_model.h"

namespace hexapose {

/// What lengths that are known to a resolution r (m) do to each coordinate of a pose, to first order: dX =
/// J^-1 dL with the analytic Jacobian. m and rad, order x y z alpha beta gamma; infinite where the pose is
/// singular.
struct RoundingEffect {
    PoseVector bound; ///< worst case of |dL_i| <= r/2: sum_i |J^-1|_ki r/2
    PoseVector sigma; ///< standard deviation of the same rounding, r/sqrt(12) a leg, legs independent
};
RoundingEffect roundingEffect(const PlatformGeometry& geometry, const Pose& pose, double resolution);

/// How far the exact pose of the lengths can be from a computed one, and how well the lengths determine it at
/// all.
struct PoseAccuracy {
    double smallestSingularValue = 0.0; ///< of the scaled Jacobian, see singularity.h
    double condition = 0.0;             ///< largest over smallest singular value
    double offsetBound = 0.0;           ///< m; infinite where there is no bound
    double angleBound = 0.0; ///< rad: angle of the rotation from one to the other; infinite likewise
};

/// residual: Euclidean norm of the six leg errors at `pose`, m. The bound is of Newton-Kantorovich's kind:
/// along the screw motion from the pose to the exact one each length has a second derivative of at most k_i,
/// so the motion's extent rho obeys sigma rho <= residual + |k| rho^2 / 2. It holds for the exact pose next
/// to this one, and allows for the rounding of the computed lengths.
PoseAccuracy poseAccuracy(const PlatformModel& model, const Pose& pose, double residual);
/// For a single question: makes the model.
inline PoseAccuracy poseAccuracy(const PlatformGeometry& geometry, const Pose& pose, double residual) {
    return poseAccuracy(PlatformModel(geometry), pose, residual);
}

} // namespace hexapose
