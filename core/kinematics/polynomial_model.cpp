// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/kinematics/polynomial_model.h"

#include "core/geometry/fnv1a.h"
#include "core/geometry/input_error.h"
#include "core/geometry/units.h"
#include "core/kinematics/newton_raphson.h"
#include "core/kinematics/polynomial_basis.h"
#include "core/kinematics/random_poses.h"
#include "core/kinematics/singularity.h"

#include <array>
#include <cmath>

namespace hexapose {

namespace {

/// +-40 mm over the 0.2999165 m of the laboratory platform.
constexpr double kOffsetOfSize = 0.040 / 0.2999165;
constexpr double kLargestAngleDeg = 40.0;
/// A model may not reach closer to a singular pose than this (smallest singular value of the scaled
/// Jacobian).
constexpr double kSingularMargin = 0.02;
constexpr int kProbes = 2000;
constexpr int kMostHalvings = 8;

bool isRegular(const PlatformGeometry& geometry, const TrainingSpec& spec, double homeSign) {
    RandomPoses poses(spec.offsetRange, spec.angleRange, spec.seed);
    for (int k = 0; k < kProbes; ++k) {
        const SingularityMeasure measure = singularityMeasure(geometry, poses());
        if (measure.determinant * homeSign <= 0.0 || measure.smallestSingularValue < kSingularMargin)
            return false;
    }
    return true;
}

/// To three figures, so that 40 mm are 40 mm.
double rounded(double metres) {
    const double scale = std::pow(10.0, 2.0 - std::floor(std::log10(metres)));
    return std::round(metres * scale) / scale;
}

} // namespace

PoseVector PolynomialModel::evaluate(const LegLengths& lengths) const noexcept {
    const LegVector u = (lengths - lengthCentre).cwiseQuotient(lengthScale);
    std::array<double, kMaxMonomials> monomials;
    const auto count = static_cast<std::size_t>(coefficients.cols());
    fillMonomials(u, count, monomials.data());
    PoseVector pose = PoseVector::Zero();
    for (std::size_t i = 0; i < count; ++i)
        pose.noalias() += monomials[i] * coefficients.col(static_cast<Eigen::Index>(i));
    return pose;
}

std::string PolynomialModel::fingerprint() const {
    Fnv1a hash;
    hash.add(platformFingerprint);
    hash.add(static_cast<std::uint64_t>(spec.degree));
    hash.add(spec.offsetRange);
    hash.add(spec.angleRange);
    hash.add(static_cast<std::uint64_t>(spec.samples));
    hash.add(spec.seed);
    for (const LegLengths& v : {lengthCentre, lengthScale, minLength, maxLength})
        for (const double value : v)
            hash.add(value);
    hash.add(maxResidual);
    for (const double value : coefficients.reshaped())
        hash.add(value);
    return hash.hex();
}

TrainingSpec defaultTrainingSpec(const PlatformGeometry& geometry, int degree) {
    const double home = homeDeterminant(geometry);
    if (home == 0.0)
        throw InputError(geometry.name, "is singular at home, so no regression can be fitted to it");
    TrainingSpec spec;
    spec.degree = degree;
    spec.offsetRange = rounded(kOffsetOfSize * geometry.size());
    spec.angleRange = radiansFromDeg(kLargestAngleDeg);
    for (int k = 0; k < kMostHalvings && !isRegular(geometry, spec, std::copysign(1.0, home)); ++k) {
        spec.offsetRange /= 2.0;
        spec.angleRange /= 2.0;
    }
    return spec;
}

} // namespace hexapose
