// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/limits.h"

#include <algorithm>
#include <cmath>

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

MotionCheck checkPose(const PlatformModel& model, const MotionLimits& limits, const Pose& pose) {
    if (!pose.isFinite())
        return failedCheck(MotionCheck::Reason::NotFinite, 0.0, 0.0);
    const MotionCheck legs = checkLegs(limits, model.actuators(pose));
    if (!legs.ok())
        return legs;
    if (const auto outside = outsideEnvelope(limits.envelope, pose))
        return *outside;
    const SingularityMeasure measure = model.singularity(pose);
    if (!(measure.smallestSingularValue >= limits.singularityMargin))
        return failedCheck(MotionCheck::Reason::NearSingular, measure.smallestSingularValue,
                           limits.singularityMargin);
    if (limits.leastDeterminantRatio == -std::numeric_limits<double>::infinity())
        return {};
    const double q = model.ratioOf(measure.determinant);
    if (!(q >= limits.leastDeterminantRatio))
        return failedCheck(MotionCheck::Reason::WrongSideOfSingularity, q, limits.leastDeterminantRatio);
    return {};
}

} // namespace hexapose
