// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/control/limits.h"

#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton_raphson.h"
#include "core/kinematics/singularity.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hexapose {

namespace {

/// Strokes are compared with this much slack, relative to the length: a set-point at the very end of a stroke
/// must survive the conversion between mm and m.
constexpr double kStrokeSlack = 1e-12;
/// The pose at the end of the leg path is the target when it is this close, relative to the machine's size
/// and in rad.
constexpr double kSamePose = 1e-6;

bool samePose(const PlatformGeometry& geometry, const Pose& a, const Pose& b) {
    const double angle = (rotationMatrix(a.angles) - rotationMatrix(b.angles)).norm();
    return (a.offset - b.offset).norm() <= kSamePose * geometry.size() && angle <= kSamePose;
}

Verdict pathVerdict(Verdict::Reason reason, double fraction, double value, double bound) {
    Verdict verdict;
    verdict.reason = reason;
    verdict.fraction = fraction;
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

std::string toWords(const Verdict& verdict) {
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
        return "path near singular at " + std::to_string(std::lround(100.0 * verdict.fraction)) + " %";
    }
    return "";
}

Verdict checkLegs(const MotionLimits& limits, const LegLengths& lengths) {
    if (!lengths.allFinite())
        return pathVerdict(Verdict::Reason::NotFinite, 1.0, 0.0, 0.0);
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

Verdict checkPose(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& pose) {
    if (!pose.isFinite())
        return pathVerdict(Verdict::Reason::NotFinite, 1.0, 0.0, 0.0);
    const Verdict legs = checkLegs(limits, legLengths(geometry, pose));
    if (!legs.ok())
        return legs;
    const SingularityMeasure measure = singularityMeasure(geometry, pose);
    if (!(measure.smallestSingularValue >= limits.singularityMargin))
        return pathVerdict(Verdict::Reason::NearSingular, 1.0, measure.smallestSingularValue,
                           limits.singularityMargin);
    return {};
}

Verdict checkLegPath(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& from,
                     const Pose& to, int steps) {
    const Verdict target = checkPose(geometry, limits, to);
    if (!target.ok())
        return target;
    if (!from.isFinite())
        return pathVerdict(Verdict::Reason::NotFinite, 0.0, 0.0, 0.0);

    // Legs plus the sign of det J do not identify a pose; the path followed does.
    const NewtonRaphson newton(geometry, NewtonOptions{});
    const LegLengths start = legLengths(geometry, from);
    const LegLengths end = legLengths(geometry, to);
    Pose pose = from;
    for (int k = 1; k <= steps; ++k) {
        const double fraction = static_cast<double>(k) / steps;
        const ForwardResult next = newton.solve(start + fraction * (end - start), pose);
        const double margin = next.status == SolveStatus::Converged
                                  ? singularityMeasure(geometry, next.pose).smallestSingularValue
                                  : 0.0;
        if (!(margin >= limits.singularityMargin))
            return pathVerdict(Verdict::Reason::PathNearSingular, fraction, margin, limits.singularityMargin);
        pose = next.pose;
    }
    if (!samePose(geometry, pose, to))
        return pathVerdict(Verdict::Reason::OtherBranch, 1.0, 0.0, 0.0);
    return {};
}

} // namespace hexapose
