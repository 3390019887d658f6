// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/kinematics/mpr_newton.h"

#include "core/kinematics/solver_checks.h"

#include <algorithm>
#include <utility>

namespace hexapose {

namespace {

/// The regression's own error must not put a pose at the edge of the trained box outside it.
constexpr double kBoxSlack = 1.05;
constexpr double kLengthSlack = 0.01; ///< of the span of lengths met in training
constexpr double kResidualSlack = 2.0;

struct Regression {
    Pose pose;
    double residual = 0.0;
    bool insideModel = false;
};

Regression regress(const PlatformGeometry& geometry, const PolynomialModel& model,
                   const LegLengths& lengths) noexcept {
    Regression result;
    const PoseVector pose = model.evaluate(lengths);
    result.pose = Pose::fromVector(pose);
    result.residual = legResidual(geometry, lengths, result.pose);
    const LegLengths slack = kLengthSlack * (model.maxLength - model.minLength);
    result.insideModel = (lengths.array() >= (model.minLength - slack).array()).all() &&
                         (lengths.array() <= (model.maxLength + slack).array()).all() &&
                         pose.head<3>().cwiseAbs().maxCoeff() <= kBoxSlack * model.spec.offsetRange &&
                         pose.tail<3>().cwiseAbs().maxCoeff() <= kBoxSlack * model.spec.angleRange &&
                         result.residual <= kResidualSlack * model.maxResidual;
    return result;
}

std::string methodName(const PolynomialModel& model, const char* suffix) {
    return "mpr" + std::to_string(model.spec.degree) + suffix;
}

} // namespace

PolynomialRegression::PolynomialRegression(const PlatformGeometry& geometry, PolynomialModel model)
    : m_geometry(geometry), m_model(std::move(model)), m_name(methodName(m_model, "")) {}

ForwardResult PolynomialRegression::solve(const LegLengths& lengths, const Pose&) const noexcept {
    if (!areLengths(lengths))
        return withoutPose(SolveStatus::InvalidInput, 0, std::numeric_limits<double>::quiet_NaN());
    const Regression found = regress(m_geometry, m_model, lengths);
    ForwardResult result;
    result.pose = found.insideModel ? normalised(found.pose) : found.pose;
    result.status = found.insideModel ? SolveStatus::Converged : SolveStatus::OutsideModel;
    result.residual = found.residual;
    return result;
}

MprNewton::MprNewton(const PlatformGeometry& geometry, PolynomialModel model, const NewtonOptions& options)
    : m_geometry(geometry), m_model(std::move(model)), m_newton(geometry, options),
      m_tolerance(m_newton.tolerance()), m_name(methodName(m_model, "-nr")) {}

ForwardResult MprNewton::solve(const LegLengths& lengths, const Pose& start) const noexcept {
    if (!areLengths(lengths))
        return withoutPose(SolveStatus::InvalidInput, 0, std::numeric_limits<double>::quiet_NaN());
    const Regression found = regress(m_geometry, m_model, lengths);
    if (found.insideModel && found.residual <= m_tolerance)
        return {normalised(found.pose), SolveStatus::Converged, 0, found.residual, true};

    ForwardResult result = m_newton.solve(lengths, found.insideModel ? found.pose : start);
    int iterations = result.iterations;
    for (const Pose& other : {start, Pose{}}) {
        if (result.isUsable())
            break;
        const ForwardResult again = m_newton.solve(lengths, other);
        iterations += again.iterations;
        if (again.isUsable())
            result = again;
    }
    result.iterations = iterations;
    if (!found.insideModel && result.status == SolveStatus::Converged)
        result.status = SolveStatus::OutsideModel;
    return result;
}

} // namespace hexapose
