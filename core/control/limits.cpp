// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/control/limits.h"

#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/singularity.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hexapose {

namespace {

/// Strokes are compared with this much slack, relative to the length: a set-point at the very end of a stroke
/// must survive the conversion between mm and m.
constexpr double kStrokeSlack = 1e-12;
Verdict verdictOf(Verdict::Reason reason, double value, double bound) {
    Verdict verdict;
    verdict.reason = reason;
    verdict.value = value;
    verdict.bound = bound;
    return verdict;
}

} // namespace

MotionLimits motionLimits(const PlatformGeometry& geometry, std::optional<double> controllerMin,
                          std::optional<double> controllerMax) {
    MotionLimits limits;
    for (int i = 0; i < kLegCount; ++i) {
        const Leg& leg = geometry.legs[static_cast<std::size_t>(i)];
        limits.minLength[i] = std::max(leg.minLength, controllerMin.value_or(leg.minLength));
        limits.maxLength[i] = std::min(leg.maxLength, controllerMax.value_or(leg.maxLength));
    }
    return limits;
}

namespace {

std::string reasonWords(const Verdict& verdict) {
    static constexpr const char* kAxes[] = {"", "x", "y", "z", "alpha", "beta", "gamma"};
    const std::string leg = "leg " + std::to_string(verdict.leg);
    switch (verdict.reason) {
    case Verdict::Reason::Ok:
        return "ok";
    case Verdict::Reason::NotFinite:
        return "invalid-input";
    case Verdict::Reason::LegAboveMax:
        return leg + " above max_mm";
    case Verdict::Reason::LegBelowMin:
        return leg + " below min_mm";
    case Verdict::Reason::NearSingular:
        return "near singular";
    case Verdict::Reason::OtherBranch:
        return "other branch";
    case Verdict::Reason::PathNearSingular:
        return "path near singular";
    case Verdict::Reason::OutsideEnvelope:
        return std::string(kAxes[verdict.axis]) + " outside the envelope";
    case Verdict::Reason::OtherSide:
        return "across the singular poses";
    case Verdict::Reason::LegTooFast:
        return leg + " too fast";
    case Verdict::Reason::LegTooHard:
        return leg + " accelerated too hard";
    }
    return "";
}

} // namespace

std::string toWords(const Verdict& verdict) {
    const bool onTheWay = verdict.fraction < 1.0 || verdict.reason == Verdict::Reason::PathNearSingular;
    return reasonWords(verdict) +
           (onTheWay ? " at " + std::to_string(std::lround(100.0 * verdict.fraction)) + " %" : "");
}

Verdict checkLegs(const MotionLimits& limits, const LegLengths& lengths) {
    if (!lengths.allFinite())
        return verdictOf(Verdict::Reason::NotFinite, 0.0, 0.0);
    Verdict worst;
    double worstBy = 0.0;
    for (int i = 0; i < kLegCount; ++i) {
        const double above = lengths[i] - limits.maxLength[i] * (1.0 + kStrokeSlack);
        const double below = limits.minLength[i] * (1.0 - kStrokeSlack) - lengths[i];
        if (std::max(above, below) <= worstBy)
            continue;
        worstBy = std::max(above, below);
        const bool isAbove = above > below;
        worst.reason = isAbove ? Verdict::Reason::LegAboveMax : Verdict::Reason::LegBelowMin;
        worst.leg = i + 1;
        worst.value = lengths[i];
        worst.bound = isAbove ? limits.maxLength[i] : limits.minLength[i];
    }
    return worst;
}

std::optional<Verdict> outsideEnvelope(const PoseEnvelope& envelope, const Pose& pose) {
    const PoseVector coordinates = pose.toVector();
    for (int axis = 0; axis < 6; ++axis) {
        if (std::abs(coordinates[axis]) <= envelope.furthest[axis] * (1.0 + kStrokeSlack))
            continue;
        Verdict verdict =
            verdictOf(Verdict::Reason::OutsideEnvelope, coordinates[axis], envelope.furthest[axis]);
        verdict.axis = axis + 1;
        return verdict;
    }
    return std::nullopt;
}

MotionLimits limitsFrom(MotionLimits limits, const LegLengths& lengths, double within) {
    for (int i = 0; i < kLegCount; ++i) {
        if (lengths[i] - limits.maxLength[i] <= within)
            limits.maxLength[i] = std::max(limits.maxLength[i], lengths[i]);
        if (limits.minLength[i] - lengths[i] <= within)
            limits.minLength[i] = std::min(limits.minLength[i], lengths[i]);
    }
    return limits;
}

Verdict checkPose(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& pose) {
    if (!pose.isFinite())
        return verdictOf(Verdict::Reason::NotFinite, 0.0, 0.0);
    const Verdict legs = checkLegs(limits, legLengths(geometry, pose));
    if (!legs.ok())
        return legs;
    if (const auto outside = outsideEnvelope(limits.envelope, pose))
        return *outside;
    const SingularityMeasure measure = singularityMeasure(geometry, pose);
    if (!(measure.smallestSingularValue >= limits.singularityMargin))
        return verdictOf(Verdict::Reason::NearSingular, measure.smallestSingularValue,
                         limits.singularityMargin);
    if (limits.leastDeterminantRatio == -std::numeric_limits<double>::infinity())
        return {};
    const double q = measure.determinant / singularityMeasure(geometry, Pose{}).determinant;
    if (!(q >= limits.leastDeterminantRatio))
        return verdictOf(Verdict::Reason::OtherSide, q, limits.leastDeterminantRatio);
    return {};
}

} // namespace hexapose
