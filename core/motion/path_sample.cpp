// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/path_sample.h"

#include "core/geometry/singular_values.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapose {

MotionCheck failedAlongPath(MotionCheck::Reason reason, double fraction, double value, double bound) {
    MotionCheck check;
    check.reason = reason;
    check.fraction = std::min(fraction, std::nextafter(1.0, 0.0));
    check.value = value;
    check.bound = bound;
    return check;
}

PathSample::PathSample(const LegEquations& equations, const Pose& pose)
    : m_evaluation(equations.evaluate(equations.placementOf(pose), LegEquations::Legs::Zero())),
      m_jacobian(equations.jacobian(m_evaluation)),
      m_arm((m_evaluation.rx.square() + m_evaluation.ry.square() + m_evaluation.rz.square()).sqrt()),
      m_spread(equations.spread()) {
    if (m_jacobian.allFinite())
        m_smallest = singularValues(m_jacobian)[5];
}

double PathSample::determinant() const {
    return m_jacobian.allFinite() ? m_jacobian.determinant() : 0.0;
}

double PathSample::jacobianChange(double shift, double turn) const {
    // A joint moves by u = shift + arm turn at most, so its leg is no shorter than |d| - u, and the unit
    // vector n along it turns by u / (|d| - u) at most. A row (n, r x n / spread) changes by that, and by
    // that and the turn of r, times the arm.
    const LegEquations::Legs u = shift + turn * m_arm;
    const LegEquations::Legs least = m_evaluation.length - u;
    if (!(least.minCoeff() > 0.0))
        return std::numeric_limits<double>::infinity();
    const LegEquations::Legs n = u / least;
    return std::sqrt((n.square() + (m_arm / m_spread * (turn + n)).square()).sum());
}

} // namespace hexapose
