// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/regression/polynomial_model.h"

#include "core/base/fnv1a.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/pose_samples.h"
#include "core/kinematics/regression/polynomial_lanes.h"
#include "core/kinematics/singular_home.h"
#include "core/kinematics/singularity.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace hexapose {

namespace {

/// Smallest singular value that a training pose may have: 0.16 over the published range of the laboratory
/// platform. Nearer to a singularity the pose is no smooth function of the lengths any more.
constexpr double kTrainableSingularValue = 0.05;
constexpr int kProbes = 2000;
constexpr std::uint64_t kProbeSeed = 20230382;
constexpr int kMostHalvings = 20;

/// Two digits: a range that a person would choose.
double rounded(double value) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 1).ptr;
    return parseNumber({text.data(), end}).value_or(value);
}

bool isTrainable(const PlatformModel& platform, const TrainingSpec& spec) {
    PoseSamples samples(spec.offsetRange, spec.angleRange, kProbeSeed, 0);
    for (int i = 0; i < kProbes; ++i) {
        const SingularityMeasure measure = platform.singularity(samples.next());
        if (!(platform.ratioOf(measure.determinant) > 0.0) ||
            !(measure.smallestSingularValue > kTrainableSingularValue))
            return false;
    }
    return true;
}

} // namespace

Eigen::Map<const PolynomialModel::Coefficients, Eigen::Unaligned, Eigen::OuterStride<8>>
PolynomialModel::coefficients() const {
    const double* first = coefficientRows.empty() ? nullptr : coefficientRows.front().values.data();
    return {first, 6, static_cast<Eigen::Index>(coefficientRows.size())};
}

void PolynomialModel::setCoefficients(const Coefficients& coefficients) {
    coefficientRows.assign(static_cast<std::size_t>(coefficients.cols()), {});
    for (Eigen::Index i = 0; i < coefficients.cols(); ++i)
        PoseVector::Map(coefficientRows[static_cast<std::size_t>(i)].values.data()) = coefficients.col(i);
}

PoseVector PolynomialModel::evaluate(const LegLengths& lengths) const noexcept {
    const LegVector u = (lengths - lengthCentre).cwiseQuotient(lengthScale);
    PoseVector pose;
    evaluatePolynomials(spec.degree, u.data(), coefficientRows.front().values.data(), pose.data());
    return pose;
}

std::string PolynomialModel::fingerprint() const {
    Fnv1a hash;
    hash.add(platformFingerprint);
    hash.add(specFingerprint(spec));
    for (int i = 0; i < kLegCount; ++i) {
        hash.add(lengthCentre[i]);
        hash.add(lengthScale[i]);
    }
    for (const double coefficient : coefficients().reshaped())
        hash.add(coefficient);
    return hash.hex();
}

std::string specFingerprint(const TrainingSpec& spec) {
    Fnv1a hash;
    hash.add(static_cast<std::uint64_t>(spec.degree));
    hash.add(spec.offsetRange);
    hash.add(spec.angleRange);
    hash.add(static_cast<std::uint64_t>(spec.samples));
    hash.add(spec.seed);
    return hash.hex();
}

TrainingSpec defaultTrainingSpec(const PlatformGeometry& geometry, int degree) {
    const PlatformModel platform(geometry);
    if (platform.homeDeterminant() == 0.0)
        throw InputError("platform \"" + geometry.name + "\"",
                         faultOfHome(geometry).value_or("its geometry is singular at home"));
    TrainingSpec spec;
    spec.degree = degree;
    spec.offsetRange = rounded(geometry.size() * 2.0 / 15.0); // 40 mm of 300
    spec.angleRange = radiansFromDeg(40.0);
    for (int i = 0; i < kMostHalvings; ++i) {
        if (isTrainable(platform, spec))
            return spec;
        spec.offsetRange /= 2.0;
        spec.angleRange /= 2.0;
    }
    throw InputError("platform \"" + geometry.name + "\"",
                     faultOfHome(geometry).value_or("its geometry is too close to singular at home"));
}

TrainingSpec withDefaults(TrainingSpec spec, const PlatformGeometry& geometry) {
    if (spec.offsetRange != 0.0 || spec.angleRange != 0.0)
        return spec;
    const TrainingSpec own = defaultTrainingSpec(geometry, spec.degree);
    spec.offsetRange = own.offsetRange;
    spec.angleRange = own.angleRange;
    return spec;
}

} // namespace hexapose
