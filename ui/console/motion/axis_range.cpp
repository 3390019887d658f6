// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/axis_range.h"

#include "core/kinematics/inverse_kinematics.h"

#include <functional>
#include <numbers>

namespace hexapose {

namespace {

constexpr int kStepsOut = 64; ///< the first limit along the path is the one that counts
constexpr int kHalvings = 12;
constexpr int kMarginSteps = 16; ///< the singularity margin changes slowly, and costs more to know

using Allowed = std::function<bool(double)>;

/// How far every pose is allowed: looked at in `steps`, the end halved down to.
double allowedTravel(double reach, int steps, const Allowed& allowed) {
    double good = 0.0;
    double bad = reach;
    for (int step = 1; step <= steps; ++step) {
        const double offset = reach * step / steps;
        if (!allowed(offset)) {
            bad = offset;
            break;
        }
        good = offset;
    }
    for (int i = 0; i < kHalvings && good != bad; ++i) {
        const double middle = (good + bad) / 2.0;
        (allowed(middle) ? good : bad) = middle;
    }
    return good;
}

bool inStrokes(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& pose) {
    const LegLengths lengths = legLengths(geometry, pose);
    return (lengths.array() >= limits.minLength.array()).all() &&
           (lengths.array() <= limits.maxLength.array()).all();
}

/// No leg changes faster than the platform moves, so the strokes bound the distance from above.
double reachOf(const MotionLimits& limits, int coordinate) {
    return coordinate < 3 ? 2.0 * limits.maxLength.maxCoeff() : std::numbers::pi / 2.0;
}

} // namespace

std::optional<std::pair<double, double>>
axisRange(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& pose, int coordinate) {
    if (!checkPose(geometry, limits, pose).ok()) {
        return std::nullopt;
    }
    const PoseVector start = pose.toVector();
    const auto end = [&](double reach) {
        return start[coordinate] + allowedTravel(reach, kStepsOut, [&](double offset) {
                   PoseVector at = start;
                   at[coordinate] += offset;
                   return inStrokes(geometry, limits, Pose::fromVector(at));
               });
    };
    const double reach = reachOf(limits, coordinate);
    return std::pair(end(-reach), end(reach));
}

std::optional<double> jogRange(const MotionPlanner& planner, const Pose& pose,
                               const JogDirection& direction) {
    if (!planner.check(pose).ok()) {
        return std::nullopt;
    }
    const MotionLimits& limits = planner.limits();
    const double strokes = allowedTravel(reachOf(limits, direction.axis), kStepsOut, [&](double travel) {
        const Pose at = stepped(pose, direction, travel);
        return inStrokes(planner.model().geometry(), limits, at) && !outsideEnvelope(limits.envelope, at);
    });
    return allowedTravel(strokes, kMarginSteps,
                         [&](double travel) { return planner.check(stepped(pose, direction, travel)).ok(); });
}

} // namespace hexapose
