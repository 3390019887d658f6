// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/regression/polynomial_model.h"

#include <string>
#include <utility>

namespace hexapose {

/// The regression alone ("mpr2", "mpr3"; Eq. 16). Status Converged within the model's range, else
/// OutsideModel; iterations 0; residual of the pose it gives, m. `start` is not used.
class PolynomialRegression final : public ForwardSolver {
public:
    /// The model must be one of this geometry, trained or loaded; makeForwardSolver() checks that.
    PolynomialRegression(SharedModel platform, PolynomialModel model);
    PolynomialRegression(const PlatformGeometry& geometry, PolynomialModel model)
        : PolynomialRegression(makeModel(geometry), std::move(model)) {}
    ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept override;
    std::string_view name() const noexcept override { return m_name; }

private:
    SharedModel m_platform;
    PolynomialModel m_model;
    std::string m_name;
};

/// MPR-NR (section 2.6): regression (Eq. 16), then Newton-Raphson with the exact derivative where the
/// regression does not already meet the tolerance. Outside the model's range Newton starts from `start` and
/// the status is OutsideModel. The other statuses are those of NewtonRaphson.
class MprNewton final : public ForwardSolver {
public:
    /// The model as in PolynomialRegression.
    MprNewton(SharedModel platform, PolynomialModel model, const NewtonOptions& options);
    MprNewton(const PlatformGeometry& geometry, PolynomialModel model, const NewtonOptions& options)
        : MprNewton(makeModel(geometry), std::move(model), options) {}
    ForwardResult solve(const LegLengths& lengths, const Pose& start) const noexcept override;
    std::string_view name() const noexcept override { return m_name; }

private:
    ForwardResult solveValid(const LegLengths& lengths, const Pose& start) const noexcept;
    void solveBeside(ForwardResult& result, bool fromModel, bool inside, const LegLengths& lengths,
                     const Pose& start) const noexcept;

    PolynomialModel m_model;
    NewtonRaphson m_newton;
    std::string m_name;
};

} // namespace hexapose
