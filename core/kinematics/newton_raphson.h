// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/kinematics/forward_solver.h"

namespace hexapose {

struct NewtonOptions {
    double tolerance = 0.0; ///< Euclidean norm of the leg errors, m; 0: defaultTolerance()
    int maxIterations = 50;
};

/// 1e-10 m for the laboratory platform, in proportion to the machine's size for any other.
double defaultTolerance(const PlatformGeometry& geometry);

/// Newton-Raphson with the exact derivative: X <- X + J(X)^-1 (L - G(X)) (Eq. 14 with the analytic Jacobian), the
/// stop test before the update. Quadratic. A step that makes the residual worse is shortened.
/// Status: Converged; IterationLimit; Singular; NoSolution when the lengths break a triangle inequality or the
/// residual stays at a positive minimum; InvalidInput; OtherBranch when det J has not home's sign.
class NewtonRaphson final : public ForwardSolver {
public:
    NewtonRaphson(const PlatformGeometry& geometry, const NewtonOptions& options);
    ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept override;
    std::string_view name() const noexcept override { return "newton"; }

private:
    PlatformGeometry m_geometry;
    NewtonOptions m_options;
    double m_homeDeterminant;
};

/// The iteration that the paper's numbers come from, only to reproduce them: joint vectors unrotated in J, omega
/// added to the Euler angles as if it were their rate, the error tested before the update and the update still
/// applied. Linear, 1.39 iterations a decade.
class NewtonAsPublished final : public ForwardSolver {
public:
    NewtonAsPublished(const PlatformGeometry& geometry, const NewtonOptions& options);
    ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept override;
    std::string_view name() const noexcept override { return "newton-as-published"; }

private:
    PlatformGeometry m_geometry;
    NewtonOptions m_options;
    double m_homeDeterminant;
};

} // namespace hexapose
