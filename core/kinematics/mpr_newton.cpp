// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/mpr_newton.h"

#include "core/kinematics/solver_checks.h"

#include <utility>

namespace hexapose {

namespace {

/// Slack of the tests for "within what the model was trained on": training poses are a sample of their box.
constexpr double kLengthSlack = 0.02;   // of the range of each length met in training
constexpr double kPoseSlack = 0.05;     // of the range of each coordinate, beside the model's own error
constexpr double kResidualFactor = 2.0; // of the largest residual in training

struct Regression {
    Pose pose;
    double residual;
    bool inside;
};

Regression regress(const PlatformGeometry& geometry, const PolynomialModel& model,
                   const LegLengths& lengths) noexcept {
    const PoseVector coordinates = model.evaluate(lengths);
    const Pose pose = Pose::fromVector(coordinates);
    const double residual = legResidual(geometry, lengths, pose);
    const LegVector slack = kLengthSlack * (model.maxLength - model.minLength);
    PoseVector box;
    box << Eigen::Vector3d::Constant(model.spec.offsetRange),
        Eigen::Vector3d::Constant(model.spec.angleRange);
    box = (1.0 + kPoseSlack) * box + model.maxError;
    const bool inside = ((lengths - model.minLength + slack).array() >= 0.0).all() &&
                        ((model.maxLength - lengths + slack).array() >= 0.0).all() &&
                        ((box - coordinates.cwiseAbs()).array() >= 0.0).all() &&
                        residual <= kResidualFactor * model.maxResidual;
    return {pose, residual, inside};
}

std::string methodName(const PolynomialModel& model, const char* ending) {
    return "mpr" + std::to_string(model.spec.degree) + ending;
}

} // namespace

PolynomialRegression::PolynomialRegression(const PlatformGeometry& geometry, PolynomialModel model)
    : m_geometry(geometry), m_model(std::move(model)), m_name(methodName(m_model, "")) {}

ForwardResult PolynomialRegression::solve(const LegLengths& lengths, const Pose&) const noexcept {
    if (!areLengths(lengths))
        return withoutPose(SolveStatus::InvalidInput, 0, kNoNumber);
    const Regression found = regress(m_geometry, m_model, lengths);
    if (!found.pose.isFinite()) // lengths so far out that the polynomial overflows
        return withoutPose(SolveStatus::OutsideModel, 0, kNoNumber);
    return {normalised(found.pose), found.inside ? SolveStatus::Converged : SolveStatus::OutsideModel, 0,
            found.residual, found.inside};
}

MprNewton::MprNewton(const PlatformGeometry& geometry, PolynomialModel model, const NewtonOptions& options)
    : m_geometry(geometry), m_model(std::move(model)), m_newton(geometry, options),
      m_name(methodName(m_model, "-nr")) {}

ForwardResult MprNewton::solve(const LegLengths& lengths, const Pose& start) const noexcept {
    if (!areLengths(lengths) || !start.isFinite())
        return withoutPose(SolveStatus::InvalidInput, 0, kNoNumber);
    const Regression found = regress(m_geometry, m_model, lengths);
    ForwardResult result;
    int iterations = 0;
    const auto solvedFrom = [&](const Pose& from) {
        const ForwardResult attempt = m_newton.solve(lengths, from);
        iterations += attempt.iterations;
        // The first failure stays the answer unless a later start succeeds.
        if (attempt.status == SolveStatus::Converged || iterations == attempt.iterations)
            result = attempt;
        return attempt.status == SolveStatus::Converged;
    };
    if ((found.inside && solvedFrom(found.pose)) || solvedFrom(start) || solvedFrom(Pose{})) {
        if (!found.inside)
            result.status = SolveStatus::OutsideModel;
    }
    result.iterations = iterations;
    return result;
}

} // namespace hexapose
