// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/finite_step_solver.h"

#include "core/kinematics/solver_checks.h"

namespace hexapose {

namespace {

/// Residual over the machine's size beyond which a pose is not one of these lengths.
constexpr double kDefaultTolerance = 0.01;
/// Of the triangle inequalities, over the machine's size: rounding.
constexpr double kSlack = 1e-9;

} // namespace

FiniteStepSolver::FiniteStepSolver(const SharedModel& model, const FiniteStepOptions& options)
    : m_model(model), m_path(model), m_options(options) {
    if (!(m_options.tolerance > 0.0))
        m_options.tolerance = kDefaultTolerance * m_model->size();
}

ForwardResult FiniteStepSolver::solve(const LegLengths& lengths, const Pose& start) const noexcept {
    if (!areValidLengths(lengths) || !start.isFinite())
        return failure(SolveStatus::InvalidInput, 0, kNoNumber);
    const LegEquations& equations = m_model->equations();
    if (equations.areUnreachable(equations.scaled(lengths), kSlack))
        return failure(SolveStatus::NoSolution, 0, kNoNumber);
    const PathResult path = m_path.followStraight(start, lengths, m_options.steps, m_options.form);
    if (path.end == PathEnd::InvalidInput)
        return failure(SolveStatus::InvalidInput, 0, kNoNumber);
    const double residual = legResidual(m_model->geometry(), lengths, path.pose);
    const bool accurate = residual <= m_options.tolerance;
    const SolveStatus status = path.end == PathEnd::Singular ? SolveStatus::Singular
                               : accurate                    ? SolveStatus::Converged
                                                             : SolveStatus::IterationLimit;
    return {path.pose, status, path.step, residual, accurate};
}

} // namespace hexapose
