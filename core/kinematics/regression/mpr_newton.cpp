// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/regression/mpr_newton.h"

#include "core/kinematics/solver_checks.h"

#include <limits>
#include <utility>

namespace hexapose {

namespace {

/// Slack of the tests for "within what the model was trained on": training poses are a sample of their box.
constexpr double kLengthSlack = 0.02;   // of the range of each length met in training
constexpr double kPoseSlack = 0.05;     // of the range of each coordinate, beside the model's own error
constexpr double kResidualFactor = 2.0; // of the largest residual in training

/// Whether lengths and the pose that the regression gives lie in what it was trained on.
bool isInside(const PolynomialModel& model, const LegLengths& lengths, const PoseVector& pose) noexcept {
    const LegVector slack = kLengthSlack * (model.maxLength - model.minLength);
    PoseVector box;
    box << Eigen::Vector3d::Constant(model.spec.offsetRange),
        Eigen::Vector3d::Constant(model.spec.angleRange);
    box = (1.0 + kPoseSlack) * box + model.maxError;
    return ((lengths - model.minLength + slack).array() >= 0.0).all() &&
           ((model.maxLength - lengths + slack).array() >= 0.0).all() &&
           ((box - pose.cwiseAbs()).array() >= 0.0).all();
}

std::string methodName(const PolynomialModel& model, const char* ending) {
    return "mpr" + std::to_string(model.spec.degree) + ending;
}

} // namespace

PolynomialRegression::PolynomialRegression(SharedModel platform, PolynomialModel model)
    : m_platform(std::move(platform)), m_model(std::move(model)), m_name(methodName(m_model, "")) {}

ForwardResult PolynomialRegression::solve(const LegLengths& lengths, const Pose&) const noexcept {
    if (!areValidLengths(lengths))
        return failure(SolveStatus::InvalidInput, 0, kNoNumber);
    const PoseVector found = m_model.evaluate(lengths);
    if (!found.allFinite()) // lengths so far out that the polynomial overflows
        return failure(SolveStatus::OutsideModel, 0, kNoNumber);
    const Pose pose = Pose::fromVector(found);
    const double residual = legResidual(m_platform->geometry(), lengths, pose);
    const bool inside =
        isInside(m_model, lengths, found) && residual <= kResidualFactor * m_model.maxResidual;
    return {normalised(pose), inside ? SolveStatus::Converged : SolveStatus::OutsideModel, 0, residual,
            inside};
}

MprNewton::MprNewton(SharedModel platform, PolynomialModel model, const NewtonOptions& options)
    : m_model(std::move(model)), m_newton(std::move(platform), options), m_name(methodName(m_model, "-nr")) {}

ForwardResult MprNewton::solve(const LegLengths& lengths, const Pose& start) const noexcept {
    if (!areValidLengths(lengths) || !start.isFinite())
        return failure(SolveStatus::InvalidInput, 0, kNoNumber);
    const PoseVector found = m_model.evaluate(lengths);
    ForwardResult result;
    int iterations = 0;
    bool isFirst = true;
    double startResidual = std::numeric_limits<double>::infinity();
    const auto solvedFrom = [&](const Pose& from) {
        const ForwardResult attempt = m_newton.solve(lengths, from, startResidual);
        iterations += attempt.iterations;
        // The first failure stays the answer unless a later start succeeds.
        if (attempt.status == SolveStatus::Converged || isFirst)
            result = attempt;
        isFirst = false;
        return attempt.status == SolveStatus::Converged;
    };
    bool inside = isInside(m_model, lengths, found);
    if (inside) {
        const bool solved = solvedFrom(Pose::fromVector(found));
        inside = startResidual <= kResidualFactor * m_model.maxResidual;
        if (solved && inside) {
            result.iterations = iterations;
            return result;
        }
    }
    // Who finds no solution has looked from home too.
    const bool mayHomeDo = !start.toVector().isZero(0.0);
    if (solvedFrom(start) || (mayHomeDo && result.status != SolveStatus::NoSolution && solvedFrom(Pose{})))
        result.status = inside ? SolveStatus::Converged : SolveStatus::OutsideModel;
    result.iterations = iterations;
    return result;
}

} // namespace hexapose
