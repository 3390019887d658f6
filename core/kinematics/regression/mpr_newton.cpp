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
    return solveValid(lengths, start);
}

ForwardResult MprNewton::solveValid(const LegLengths& lengths, const Pose& start) const noexcept {
    const PoseVector found = m_model.evaluate(lengths);
    bool inside = isInside(m_model, lengths, found);
    double startResidual = std::numeric_limits<double>::infinity();
    // One result, in place: a copy of it costs a tenth of the solution.
    ForwardResult result = m_newton.solve(lengths, inside ? Pose::fromVector(found) : start, startResidual);
    const bool fromModel = inside;
    inside = inside && startResidual <= kResidualFactor * m_model.maxResidual;
    if (result.status != SolveStatus::Converged || !inside)
        solveBeside(result, fromModel, inside, lengths, start);
    return result;
}

/// Where the regression has not led to the pose: from the given start and from home. The first failure stays
/// the answer unless a later start succeeds.
void MprNewton::solveBeside(ForwardResult& result, bool fromModel, bool inside, const LegLengths& lengths,
                            const Pose& start) const noexcept {
    int iterations = result.iterations;
    const auto solvedFrom = [&](const Pose& from) {
        const ForwardResult attempt = m_newton.solve(lengths, from);
        iterations += attempt.iterations;
        if (attempt.status == SolveStatus::Converged)
            result = attempt;
        return attempt.status == SolveStatus::Converged;
    };
    // NoSolution already includes a search from home.
    const bool mayHomeDo = !start.toVector().isZero(0.0);
    const bool solved = fromModel ? solvedFrom(start) : result.status == SolveStatus::Converged;
    if (solved || (mayHomeDo && result.status != SolveStatus::NoSolution && solvedFrom(Pose{})))
        result.status = inside ? SolveStatus::Converged : SolveStatus::OutsideModel;
    result.iterations = iterations;
}

} // namespace hexapose
