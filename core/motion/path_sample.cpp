// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/path_sample.h"

#include "core/kinematics/extreme_singular_values.h"
#include "core/kinematics/singularity.h"

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

PathSample::PathSample(const LegEquations& equations, const Placement& placement)
    : m_evaluation(equations.evaluate(placement, LegEquations::Legs::Zero())),
      m_jacobian(equations.jacobian(m_evaluation)),
      m_arm((m_evaluation.rx.square() + m_evaluation.ry.square() + m_evaluation.rz.square()).sqrt()),
      m_spread(equations.spread()) {
    if (m_jacobian.allFinite())
        m_smallest = extremeSingularValues(m_jacobian).smallest;
}

double PathSample::determinant() const {
    return m_jacobian.allFinite() ? determinantOf(m_jacobian) : 0.0;
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
