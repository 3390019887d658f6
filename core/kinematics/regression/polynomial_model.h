// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hexapose {

/// What a model is trained on: poses uniform in a box about home. Where both ranges are 0 the platform's own
/// are taken (defaultTrainingSpec), so that TrainingSpec{} is good for every platform.
struct TrainingSpec {
    int degree = 3;                ///< 1 to 4
    double offsetRange = 0.0;      ///< +-, m, each axis
    double angleRange = 0.0;       ///< +-, rad, each axis
    std::int64_t samples = 100000; ///< poses
    std::uint64_t seed = 1;        ///< of their random numbers
};

/// The coefficients of one monomial: x y z (m) alpha beta gamma (rad), and two zeros, so that a row is a
/// cache line, which one load of the vector unit takes.
struct alignas(64) CoefficientRow {
    std::array<double, 8> values{};
};

/// A regression of the pose on the distinct monomials up to `degree` of the centred and scaled lengths (Eq.
/// 16). u_i = (l_i - lengthCentre_i) / lengthScale_i; pose = coefficients() * monomials(u). Monomial order:
/// as in polynomial_basis.h.
struct PolynomialModel {
    TrainingSpec spec;
    std::string platformFingerprint; ///< PlatformGeometry::fingerprint() of the one it belongs to
    LegLengths lengthCentre = LegLengths::Zero(); ///< m
    LegLengths lengthScale = LegLengths::Ones();  ///< m
    LegLengths minLength = LegLengths::Zero();    ///< smallest and largest length met in training, m
    LegLengths maxLength = LegLengths::Zero();
    double maxResidual = 0.0; ///< largest leg residual of the regression over the training poses, m
    PoseVector maxError = PoseVector::Zero();    ///< largest error of each coordinate there, m and rad
    std::vector<CoefficientRow> coefficientRows; ///< monomialCount(degree)

    using Coefficients = Eigen::Matrix<double, 6, Eigen::Dynamic>;
    /// The same as a matrix: 6 x monomialCount(degree); rows x y z (m) alpha beta gamma (rad).
    Eigen::Map<const Coefficients, Eigen::Unaligned, Eigen::OuterStride<8>> coefficients() const;
    void setCoefficients(const Coefficients& coefficients);
    /// The regression's pose, from lengths in m. Of a trained or loaded model; extrapolates without a word
    /// outside of its range. Allocates nothing.
    PoseVector evaluate(const LegLengths& lengths) const noexcept;
    /// Identity of the model for logs: FNV-1a over spec, platform and coefficients, 16 hex digits.
    std::string fingerprint() const;
};

/// FNV-1a over a specification, 16 hex digits.
std::string specFingerprint(const TrainingSpec& spec);

/// The range a model is trained on by default: +-40 mm and +-40 deg for the laboratory
/// platform, the displacement in proportion to the machine's size, and both halved until no sampled pose is
/// singular or past a singularity. Throws InputError for a geometry that is singular at home or too close to
/// it. The degree is not checked here but by trainModel().
TrainingSpec defaultTrainingSpec(const PlatformGeometry& geometry, int degree);
/// With the platform's own ranges where both are 0; throws as defaultTrainingSpec() does.
TrainingSpec withDefaults(TrainingSpec spec, const PlatformGeometry& geometry);

} // namespace hexapose
