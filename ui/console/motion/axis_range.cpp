// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/axis_range.h"

#include "core/motion/limits.h"

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

/// No leg changes faster than the platform moves, so the strokes bound the distance from above.
double reachOf(const MotionLimits& limits, int coordinate) {
    return coordinate < 3 ? 2.0 * limits.maxLength.maxCoeff() : std::numbers::pi / 2.0;
}

/// From where the pose is allowed, along poseAt(travel) up to `reach`: strokes and envelope first, which cost
/// little.
double travelWithin(const PlatformModel& model, const MotionLimits& limits, double reach,
                    const std::function<Pose(double)>& poseAt) {
    const double strokes = allowedTravel(reach, kStepsOut, [&](double travel) {
        const Pose at = poseAt(travel);
        return checkLegs(limits, model.actuators(at)).ok() && !outsideEnvelope(limits.envelope, at);
    });
    return allowedTravel(strokes, kMarginSteps,
                         [&](double travel) { return checkPose(model, limits, poseAt(travel)).ok(); });
}

} // namespace

std::optional<std::pair<double, double>> axisRange(const MotionPlanner& planner, const Pose& pose,
                                                   int coordinate) {
    const MotionLimits limits = planner.limitsAt(pose);
    if (!checkPose(planner.model(), limits, pose).ok()) {
        return std::nullopt;
    }
    const PoseVector start = pose.toVector();
    const auto end = [&](double reach) {
        return start[coordinate] + travelWithin(planner.model(), limits, reach, [&](double offset) {
                   PoseVector at = start;
                   at[coordinate] += offset;
                   return Pose::fromVector(at);
               });
    };
    const double reach = reachOf(limits, coordinate);
    return std::pair(end(-reach), end(reach));
}

std::optional<double> jogRange(const MotionPlanner& planner, const Pose& pose,
                               const JogDirection& direction) {
    const MotionLimits& limits = planner.limits();
    if (!planner.check(pose).ok()) {
        return std::nullopt;
    }
    return travelWithin(planner.model(), limits, reachOf(limits, direction.axis),
                        [&](double travel) { return stepped(pose, direction, travel); });
}

} // namespace hexapose
