// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/forward_solver.h"
#include "core/kinematics/newton/newton_iteration.h"
#include "core/kinematics/platform_model.h"
#include "core/kinematics/vector/newton_lanes.h"

#include <span>

namespace hexapose {

/// When to stop.
struct NewtonOptions {
    double tolerance = 0.0; ///< Euclidean norm of the leg errors, m; 0: defaultTolerance()
    int maxIterations = 50; ///< of one run
};

/// 1e-10 m for the laboratory platform, in proportion to the machine's size for any other.
double defaultTolerance(const PlatformGeometry& geometry);

/// Newton-Raphson with the exact derivative (Eq. 14 on rotations instead of Euler angles, so that gimbal lock
/// is no obstacle), the stop test before the update. Quadratic. Plain steps first, on the processor's vector
/// unit; where they go astray, steps that are shortened when they make the residual worse; where those end on
/// another side, the pose followed along the straight path of the legs.
///
/// Converged means that the Jacobian's determinant has home's sign and that the pose is joined to home (or to
/// a `start` on home's side) by a path on which it keeps it: the straight one, or that of the legs. A pose of
/// these lengths for which that does not hold is OtherBranch. Others: IterationLimit; Singular when the
/// Jacobian cannot be inverted at the pose found or at home; NoSolution when the lengths break a triangle
/// inequality, or the residual stays at a positive minimum from `start` and no pose was reached from home and
/// thirty places about it; InvalidInput. The pose is NaN where the status has none. Iterations are those of
/// all attempts, and only one run is bound by the limit.
class NewtonRaphson final : public ForwardSolver {
public:
    NewtonRaphson(SharedModel model, const NewtonOptions& options);
    /// geometry: one that validate() accepts.
    NewtonRaphson(const PlatformGeometry& geometry, const NewtonOptions& options)
        : NewtonRaphson(makeModel(geometry), options) {}
    ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept override;
    /// The same, and the residual at `start`, m, which the first step computes anyway: to some per cent
    /// where it is a tenth of the lengths, and no less than half of it anywhere. Infinity where no step was
    /// taken.
    ForwardResult solve(const LegLengths& lengths, const Pose& start, double& startResidual) const noexcept;
    std::string_view name() const noexcept override { return "newton"; }

    /// The tolerance in force, m.
    double tolerance() const noexcept { return m_tolerance; }

    /// solve() from home of many lengths. `results` must be as long as `lengths`, which is not checked;
    /// threads: 0 for one a core.
    void solveAll(std::span<const LegLengths> lengths, std::span<ForwardResult> results,
                  unsigned threads = 1) const;

private:
    ForwardResult solveCarefully(const LegLengths& lengths, const Pose& start) const noexcept;
    ForwardResult verified(const NewtonRun& run, int iterations, const Placement& start,
                           const LegEquations::Legs& target) const noexcept;
    bool isNear(const Pose& pose, double ratio) const noexcept;
    void solveRange(std::span<const LegLengths> lengths, std::span<ForwardResult> results) const noexcept;
    void unpack(const LaneBlock& block, std::span<const LegLengths> lengths,
                std::span<ForwardResult> results) const noexcept;

    const LegEquations& equations() const noexcept { return m_model->equations(); }

    SharedModel m_model;
    double m_tolerance;
    int m_maxIterations;
    double m_homeDeterminant; ///< of the model, near at hand
    LaneMachine m_lanes;
};

/// The iteration that the paper's numbers come from (Eq. 14 with Eq. 8), only to reproduce them: joint
/// vectors unrotated in J, omega added to the Euler angles as if it were their rate, the error tested before
/// the update and the update still applied. Linear, 1.39 iterations a decade. Newton's statuses, but
/// NoSolution only by the triangle inequalities.
class NewtonAsPublished final : public ForwardSolver {
public:
    NewtonAsPublished(SharedModel model, const NewtonOptions& options);
    NewtonAsPublished(const PlatformGeometry& geometry, const NewtonOptions& options)
        : NewtonAsPublished(makeModel(geometry), options) {}
    ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept override;
    std::string_view name() const noexcept override { return "newton-as-published"; }

private:
    SharedModel m_model;
    double m_tolerance;
    int m_maxIterations;
};

} // namespace hexapose
