// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/leg_equations.h"

namespace hexapose {

/// Part of the solvers' inside, as all in this header: how a run ended.
enum class NewtonEnd {
    Solved,     ///< residual within the tolerance
    Limit,      ///< iterations used up, or rounding stopped them
    Stationary, ///< the residual stays at a positive minimum
};

/// One run of Newton's iteration from one start. All without units.
struct NewtonRun {
    Placement placement;
    LegEquations::Evaluation evaluation;
    NewtonEnd end = NewtonEnd::Limit;
    int iterations = 0;
    double determinant = 0.0;  ///< of the Jacobian before the last Newton step; 0 when there was none
    double lastStepNorm = 0.0; ///< of that step
};

/// What to do when a full step makes the residual worse.
enum class StepGuard {
    Shorten, ///< shorten it; where that does not help either, go on with damped steps (Levenberg-Marquardt)
    None,    ///< take it all the same: reaches solutions behind a hill of the residual
};

/// Newton's iteration (Eq. 14) until the residual is within the tolerance, in machine sizes. The start must
/// be finite.
NewtonRun runNewton(const LegEquations& equations, const LegEquations::Legs& target, const Placement& start,
                    double tolerance, int maxIterations, StepGuard guard) noexcept;

} // namespace hexapose
