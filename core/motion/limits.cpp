// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/limits.h"

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
MotionCheck failedCheck(MotionCheck::Reason reason, double value, double bound) {
    MotionCheck check;
    check.reason = reason;
    check.value = value;
    check.bound = bound;
    return check;
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

std::string reasonWords(const MotionCheck& check) {
    static constexpr const char* kAxes[] = {"", "x", "y", "z", "alpha", "beta", "gamma"};
    const std::string leg = "leg " + std::to_string(check.leg);
    switch (check.reason) {
    case MotionCheck::Reason::Ok:
        return "ok";
    case MotionCheck::Reason::NotFinite:
        return "invalid-input";
    case MotionCheck::Reason::LegAboveMax:
        return leg + " above max_mm";
    case MotionCheck::Reason::LegBelowMin:
        return leg + " below min_mm";
    case MotionCheck::Reason::NearSingular:
        return "near singular";
    case MotionCheck::Reason::OtherAssemblyMode:
        return "other branch";
    case MotionCheck::Reason::PathNearSingular:
        return "path near singular";
    case MotionCheck::Reason::OutsideEnvelope:
        return std::string(kAxes[check.axis]) + " outside the envelope";
    case MotionCheck::Reason::WrongSideOfSingularity:
        return "across the singular poses";
    case MotionCheck::Reason::LegSpeed:
        return leg + " too fast";
    case MotionCheck::Reason::LegAcceleration:
        return leg + " accelerated too hard";
    case MotionCheck::Reason::PlanTooLong:
        return "too long to plan";
    case MotionCheck::Reason::StartMoved:
        return "start moved";
    case MotionCheck::Reason::LimitsChanged:
        return "limits changed";
    }
    return "";
}

} // namespace

std::string toWords(const MotionCheck& check) {
    const bool alongPath = check.fraction < 1.0 || check.reason == MotionCheck::Reason::PathNearSingular;
    return reasonWords(check) +
           (alongPath ? " at " + std::to_string(std::lround(100.0 * check.fraction)) + " %" : "");
}

MotionCheck checkLegs(const MotionLimits& limits, const LegLengths& lengths) {
    if (!lengths.allFinite())
        return failedCheck(MotionCheck::Reason::NotFinite, 0.0, 0.0);
    MotionCheck worst;
    double worstBy = 0.0;
    for (int i = 0; i < kLegCount; ++i) {
        const double above = lengths[i] - limits.maxLength[i] * (1.0 + kStrokeSlack);
        const double below = limits.minLength[i] * (1.0 - kStrokeSlack) - lengths[i];
        if (std::max(above, below) <= worstBy)
            continue;
        worstBy = std::max(above, below);
        const bool isAbove = above > below;
        worst.reason = isAbove ? MotionCheck::Reason::LegAboveMax : MotionCheck::Reason::LegBelowMin;
        worst.leg = i + 1;
        worst.value = lengths[i];
        worst.bound = isAbove ? limits.maxLength[i] : limits.minLength[i];
    }
    return worst;
}

std::optional<MotionCheck> outsideEnvelope(const PoseEnvelope& envelope, const Pose& pose) {
    const PoseVector coordinates = pose.toVector();
    for (int axis = 0; axis < 6; ++axis) {
        if (std::abs(coordinates[axis]) <= envelope.furthest[axis] * (1.0 + kStrokeSlack))
            continue;
        MotionCheck check =
            failedCheck(MotionCheck::Reason::OutsideEnvelope, coordinates[axis], envelope.furthest[axis]);
        check.axis = axis + 1;
        return check;
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

MotionCheck checkPose(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& pose) {
    if (!pose.isFinite())
        return failedCheck(MotionCheck::Reason::NotFinite, 0.0, 0.0);
    const MotionCheck legs = checkLegs(limits, legLengths(geometry, pose));
    if (!legs.ok())
        return legs;
    if (const auto outside = outsideEnvelope(limits.envelope, pose))
        return *outside;
    const SingularityMeasure measure = singularityMeasure(geometry, pose);
    if (!(measure.smallestSingularValue >= limits.singularityMargin))
        return failedCheck(MotionCheck::Reason::NearSingular, measure.smallestSingularValue,
                           limits.singularityMargin);
    if (limits.leastDeterminantRatio == -std::numeric_limits<double>::infinity())
        return {};
    const double q = measure.determinant / singularityMeasure(geometry, Pose{}).determinant;
    if (!(q >= limits.leastDeterminantRatio))
        return failedCheck(MotionCheck::Reason::WrongSideOfSingularity, q, limits.leastDeterminantRatio);
    return {};
}

} // namespace hexapose
