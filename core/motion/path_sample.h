// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/leg_equations.h"
#include "core/motion/motion_check.h"
#include "core/motion/plan_budget.h"

namespace hexapose {

/// Part of the checks' inside, as all in this header. How far below its margin the smallest singular value
/// might be between two samples that keep it.
inline constexpr double kMarginResolution = 5e-4;

MotionCheck failedAlongPath(MotionCheck::Reason reason, double fraction, double value, double bound);

inline bool expired(PlanTimer* timer) {
    return timer && timer->expired();
}

/// The scaled Jacobian (see singularity.h) at a place on a path, and how it can change next to it. Shifts are
/// of the centroid of the platform joints, in machine sizes; turns in rad.
class PathSample {
public:
    PathSample(const LegEquations& equations, const Placement& placement);

    /// Lengths in machine sizes, no target.
    const LegEquations::Evaluation& evaluation() const { return m_evaluation; }
    const LegEquations::Matrix& jacobian() const { return m_jacobian; }
    /// 0 where the Jacobian is not finite, as the determinant.
    double smallestSingularValue() const { return m_smallest; }
    double determinant() const;
    const LegEquations::Legs& arms() const { return m_arm; } ///< of the joints about their centroid
    /// Upper bound of the Frobenius norm of the Jacobian's change within this shift and turn: no singular
    /// value changes by more. Per step it grows with the step, so that it bounds the rate of change within it
    /// too. Infinite where a leg might vanish.
    double jacobianChange(double shift, double turn) const;

private:
    LegEquations::Evaluation m_evaluation;
    LegEquations::Matrix m_jacobian;
    LegEquations::Legs m_arm;
    double m_spread;
    double m_smallest = 0.0;
};

} // namespace hexapose
