// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/leg_path.h"
#include "core/kinematics/forward_solver.h"
#include "core/kinematics/platform_model.h"

namespace hexapose {

struct FiniteStepOptions {
    int steps = 1000;
    StepForm form = StepForm::Corrected;
    double tolerance = 0.0; ///< Euclidean norm of the leg errors, m; 0: a hundredth of the machine's size
};

/// Finite-step integration as a forward solver ("fsi"; Front. Mech. Eng. 2025, 20(1):7): goes from `start` to
/// the lengths along the straight path of the legs. Its pose is connected to `start`, which no solver can
/// guarantee that only uses lengths.
///
/// Converged: the path was followed to its end, and the residual is within the tolerance; the residual
/// shows how near the pose is, as the method does not iterate. IterationLimit: more steps are needed.
/// Singular: the path meets a singular pose; the pose is the last one reached, the residual what is left to
/// go. NoSolution: the lengths break a triangle inequality. Iterations are steps.
class FiniteStepSolver final : public ForwardSolver {
public:
    /// Throws InputError when no three platform joints span a triangle.
    FiniteStepSolver(const SharedModel& model, const FiniteStepOptions& options);
    FiniteStepSolver(const PlatformGeometry& geometry, const FiniteStepOptions& options)
        : FiniteStepSolver(makeModel(geometry), options) {}
    ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept override;
    std::string_view name() const noexcept override { return "fsi"; }

private:
    SharedModel m_model;
    LegPath m_path;
    FiniteStepOptions m_options;
};

} // namespace hexapose
