// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/jacobian.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/solver_checks.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <utility>

namespace hexapose {

namespace {

/// Eq. 8 as the paper computes it: leg directions at the pose, but joint vectors as they are at home.
Jacobian publishedJacobian(const PlatformGeometry& geometry, const Pose& pose, LegLengths& lengths) noexcept {
    const Eigen::Matrix3d R = rotationMatrix(pose.angles);
    const Eigen::Vector3d origin = geometry.p_OP_home_B + pose.offset;
    Jacobian J;
    for (int i = 0; i < kLegCount; ++i) {
        const Leg& leg = geometry.legs[static_cast<std::size_t>(i)];
        const Eigen::Vector3d d = origin + R * leg.p_PB_P - leg.p_OA_B;
        lengths[i] = d.norm();
        const Eigen::Vector3d n = d / lengths[i];
        J.row(i) << n.transpose(), leg.p_PB_P.cross(n).transpose();
    }
    return J;
}

} // namespace

NewtonAsPublished::NewtonAsPublished(SharedModel model, const NewtonOptions& options)
    : m_model(std::move(model)),
      m_tolerance(options.tolerance > 0.0 ? options.tolerance : defaultTolerance(m_model->geometry())),
      m_maxIterations(options.maxIterations) {}

ForwardResult NewtonAsPublished::solve(const LegLengths& lengths, const Pose& start) const noexcept {
    if (!areValidLengths(lengths) || !start.isFinite())
        return failure(SolveStatus::InvalidInput, 0, kNoNumber);
    const LegEquations& equations = m_model->equations();
    const double homeDeterminant = m_model->homeDeterminant();
    const LegEquations::Legs target = equations.scaled(lengths);
    if (equations.areUnreachable(target, m_tolerance / equations.size()))
        return failure(SolveStatus::NoSolution, 0, kNoNumber);

    ForwardResult result{start, SolveStatus::IterationLimit, 0, kNoNumber, false};
    if (homeDeterminant == 0.0)
        result.status = SolveStatus::Singular;
    PoseVector coordinates = start.toVector();
    while (result.status == SolveStatus::IterationLimit && result.iterations < m_maxIterations) {
        LegLengths reached;
        const Pose pose = Pose::fromVector(coordinates);
        const Jacobian J = publishedJacobian(m_model->geometry(), pose, reached);
        const LegLengths error = lengths - reached;
        const PoseVector next = coordinates + Eigen::PartialPivLU<Jacobian>(J).solve(error);
        if (!next.allFinite()) {
            result.status = SolveStatus::Singular;
            break;
        }
        coordinates = next; // still applied when the test below, on the error before it, ends the loop
        ++result.iterations;
        if (error.norm() < m_tolerance)
            result.status = SolveStatus::Converged;
    }
    result.pose = normalised(Pose::fromVector(coordinates));
    result.residual = legResidual(m_model->geometry(), lengths, result.pose);
    result.accurate = result.residual <= m_tolerance;
    if (result.status == SolveStatus::Converged) {
        const auto end = equations.evaluate(equations.placementOf(result.pose), target);
        result.status = branchStatus(equations.branchSign(end, kSingularValueFloor), homeDeterminant);
    }
    return result;
}

} // namespace hexapose
