// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/newton_raphson.h"

#include "core/kinematics/newton_iteration.h"
#include "core/kinematics/singularity.h"
#include "core/kinematics/solver_checks.h"

namespace hexapose {

namespace {

/// 1e-10 m over the 0.2999165 m of the laboratory platform.
constexpr double kRelativeTolerance = 1e-10 / 0.2999165;

/// Sign of the Jacobian's determinant at the end of a run; 0 where the pose is singular. Most runs end with a
/// step so short that the factorisation before it decides.
double branchSign(const LegEquations& equations, const NewtonRun& run) noexcept {
    const double margin = singularValueBound(run.determinant);
    if (2.0 * equations.jacobianChange(run.evaluation, run.lastStepNorm) < margin &&
        margin > 2.0 * kSingularValueFloor)
        return std::copysign(1.0, run.determinant);
    return equations.branchSign(run.evaluation, kSingularValueFloor);
}

SolveStatus statusOf(NewtonEnd end) noexcept {
    switch (end) {
    case NewtonEnd::Solved:
        return SolveStatus::Converged;
    case NewtonEnd::Stationary:
        return SolveStatus::NoSolution;
    case NewtonEnd::Limit:
        break;
    }
    return SolveStatus::IterationLimit;
}

} // namespace

double defaultTolerance(const PlatformGeometry& geometry) {
    return kRelativeTolerance * geometry.size();
}

double homeDeterminant(const PlatformGeometry& geometry) {
    const SingularityMeasure home = singularityMeasure(geometry, Pose{});
    return home.smallestSingularValue > kSingularValueFloor ? home.determinant : 0.0;
}

NewtonRaphson::NewtonRaphson(const PlatformGeometry& geometry, const NewtonOptions& options)
    : m_equations(geometry),
      m_tolerance(options.tolerance > 0.0 ? options.tolerance : defaultTolerance(geometry)),
      m_maxIterations(options.maxIterations), m_homeDeterminant(homeDeterminant(geometry)) {}

ForwardResult NewtonRaphson::solve(const LegLengths& lengths, const Pose& start) const noexcept {
    if (!areLengths(lengths) || !start.isFinite())
        return withoutPose(SolveStatus::InvalidInput, 0, kNoNumber);
    const LegEquations::Legs target = m_equations.scaled(lengths);
    const double tolerance = m_tolerance / m_equations.size();
    if (m_equations.breaksTriangle(target, tolerance))
        return withoutPose(SolveStatus::NoSolution, 0, kNoNumber);

    if (m_homeDeterminant == 0.0) {
        const double residual =
            m_equations.evaluate(m_equations.placementOf(start), target).residual * m_equations.size();
        return {normalised(start), SolveStatus::Singular, 0, residual, residual <= m_tolerance};
    }

    const auto attempt = [&](const Pose& from, StepGuard guard) {
        return runNewton(m_equations, target, m_equations.placementOf(from), tolerance, m_maxIterations,
                         guard);
    };
    NewtonRun run = attempt(start, StepGuard::Shorten);
    int iterations = run.iterations;
    if (run.end == NewtonEnd::Stationary) {
        // That no pose has these lengths is much to say; it must hold for other ways and from home too.
        for (const auto& [from, guard] :
             {std::pair{start, StepGuard::None}, std::pair{Pose{}, StepGuard::Shorten}}) {
            const NewtonRun other = attempt(from, guard);
            iterations += other.iterations;
            if (other.end != NewtonEnd::Solved)
                continue;
            run = other;
            break;
        }
    }

    const double residual = run.evaluation.residual * m_equations.size();
    ForwardResult result{m_equations.poseOf(run.placement), statusOf(run.end), iterations, residual,
                         run.end == NewtonEnd::Solved};
    if (result.status == SolveStatus::NoSolution)
        return withoutPose(SolveStatus::NoSolution, iterations, residual);
    if (result.status == SolveStatus::Converged)
        result.status = branchStatus(branchSign(m_equations, run), m_homeDeterminant);
    return result;
}

} // namespace hexapose
