// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/solver_checks.h"

#include "core/kinematics/inverse_kinematics.h"

namespace hexapose {

double legResidual(const PlatformGeometry& geometry, const LegLengths& lengths, const Pose& pose) noexcept {
    return (lengths - legLengths(geometry, pose)).stableNorm();
}

Pose normalised(const Pose& pose) noexcept {
    return {pose.offset, eulerAngles(rotationMatrix(pose.angles))};
}

} // namespace hexapose
