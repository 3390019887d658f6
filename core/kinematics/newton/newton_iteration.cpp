// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/newton/newton_iteration.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace hexapose {

namespace {

/// A shortened step must reach this part of the decrease that the linear model promises.
constexpr double kSufficientDecrease = 1e-4;
/// Shorter than this part of the Newton step: its direction is no good, damped steps take over.
constexpr double kShortestStep = 1.0 / 16.0;
/// Relative gradient |J^T e| / |e| below which a positive residual may count as its own minimum ...
constexpr double kFlatGradient = 1e-3;
/// ... when it also exceeds what a root this near a fold could explain (Kantorovich: root if K e / g^2 <
/// 1/2).
constexpr double kFoldFactor = 20.0;

class Iteration {
public:
    Iteration(const LegEquations& equations, const LegEquations::Legs& target, const Placement& start,
              double tolerance, int maxIterations)
        : m_equations(equations), m_target(target), m_tolerance(tolerance), m_maxIterations(maxIterations) {
        m_run.placement = start;
        m_run.evaluation = equations.evaluate(start, target);
    }

    NewtonRun run(StepGuard guard) {
        while (goesOn()) {
            LegEquations::Step step;
            const double determinant = m_equations.newtonStep(m_run.evaluation, step);
            if (determinant == 0.0 || !step.allFinite()) {
                damped();
                break;
            }
            m_run.determinant = determinant;
            m_run.lastStepNorm = step.norm();
            if (guard == StepGuard::None)
                accept(m_equations.moved(m_run.placement, step));
            else if (!guardedStep(step)) {
                damped();
                break;
            }
        }
        return m_run;
    }

private:
    /// The stop test, before any further update.
    bool goesOn() {
        if (m_run.evaluation.residual <= m_tolerance)
            m_run.end = NewtonEnd::Solved;
        return m_run.end == NewtonEnd::Limit && m_run.iterations < m_maxIterations;
    }

    void accept(const Placement& placement) { accept(placement, m_equations.evaluate(placement, m_target)); }
    void accept(const Placement& placement, const LegEquations::Evaluation& evaluation) {
        m_run.placement = placement;
        m_run.evaluation = evaluation;
        ++m_run.iterations;
    }

    /// The full step, or a shorter one where the residual would grow. False: none is any good.
    bool guardedStep(const LegEquations::Step& step) {
        const double before = m_run.evaluation.residual * m_run.evaluation.residual;
        double part = 1.0;
        do {
            const Placement placement = m_equations.moved(m_run.placement, part * step);
            const auto evaluation = m_equations.evaluate(placement, m_target);
            const double after = evaluation.residual * evaluation.residual;
            if (after < (1.0 - kSufficientDecrease * part) * before) {
                accept(placement, evaluation);
                return true;
            }
            // Minimum of the parabola through both values and the slope -2 before.
            const double best = part * part * before / (after - before + 2.0 * part * before);
            part = best >= 0.1 * part ? std::min(best, 0.5 * part) : 0.1 * part;
        } while (part >= kShortestStep);
        return false;
    }

    void damped() {
        using Square = Eigen::Matrix<double, 6, 6>;
        double damping = 1e-3, growth = 2.0;
        while (goesOn()) {
            const LegEquations::Matrix J = m_equations.jacobian(m_run.evaluation);
            const LegEquations::Step error = m_run.evaluation.error.matrix();
            const LegEquations::Step gradient = J.transpose() * error;
            const double before = m_run.evaluation.residual;
            const double slope = gradient.norm() / before;
            if (slope < kFlatGradient && before > kFoldFactor * slope * slope) {
                m_run.end = NewtonEnd::Stationary;
                return;
            }
            const Square normal = J.transpose() * J + damping * Square::Identity();
            const LegEquations::Step step = normal.llt().solve(gradient);
            const Placement placement = m_equations.moved(m_run.placement, step);
            const auto evaluation = m_equations.evaluate(placement, m_target);
            const double promised = step.dot(damping * step + gradient);
            const double gain = (before * before - evaluation.residual * evaluation.residual) / promised;
            if (gain > 0.0) {
                const double bend = 2.0 * gain - 1.0;
                accept(placement, evaluation);
                damping *= std::max(0.1, 1.0 - bend * bend * bend);
                growth = 2.0;
            } else {
                ++m_run.iterations;
                damping *= growth;
                growth *= 2.0;
            }
        }
        m_run.determinant = 0.0; // the last step was not Newton's
    }

    const LegEquations& m_equations;
    const LegEquations::Legs& m_target;
    const double m_tolerance;
    const int m_maxIterations;
    NewtonRun m_run;
};

} // namespace

NewtonRun runNewton(const LegEquations& equations, const LegEquations::Legs& target, const Placement& start,
                    double tolerance, int maxIterations, StepGuard guard) noexcept {
    return Iteration(equations, target, start, tolerance, maxIterations).run(guard);
}

} // namespace hexapose
