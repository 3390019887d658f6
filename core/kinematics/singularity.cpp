// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/singularity.h"

#include "core/geometry/singular_values.h"
#include "core/kinematics/leg_equations.h"

#include <Eigen/LU>

#include <limits>

namespace hexapose {

SingularityMeasure singularityMeasure(const PlatformGeometry& geometry, const Pose& pose) {
    const LegEquations equations(geometry);
    const LegEquations::Matrix J =
        equations.jacobian(equations.evaluate(equations.placementOf(pose), LegEquations::Legs::Zero()));
    if (!J.allFinite())
        return {0.0, 0.0, std::numeric_limits<double>::infinity()};
    const auto values = singularValues(J);
    return {J.determinant(), values[5], values[0] / values[5]};
}

} // namespace hexapose
