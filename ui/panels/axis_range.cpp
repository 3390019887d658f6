// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/axis_range.h"

#include "core/kinematics/inverse_kinematics.h"

#include <numbers>

namespace hexapose {

namespace {

constexpr int kStepsOut = 64; ///< the first limit on the way is the one that counts
constexpr int kHalvings = 12;

double limitOnTheWay(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& pose,
                     int coordinate, double reach) {
    const PoseVector start = pose.toVector();
    const auto allowed = [&](double offset) {
        PoseVector at = start;
        at[coordinate] += offset;
        const LegLengths lengths = legLengths(geometry, Pose::fromVector(at));
        return (lengths.array() >= limits.minLength.array()).all() &&
               (lengths.array() <= limits.maxLength.array()).all();
    };
    double good = 0.0;
    double bad = reach;
    for (int step = 1; step <= kStepsOut; ++step) {
        const double offset = reach * step / kStepsOut;
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
    return start[coordinate] + good;
}

} // namespace

std::optional<std::pair<double, double>>
axisRange(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& pose, int coordinate) {
    if (!checkPose(geometry, limits, pose).ok()) {
        return std::nullopt;
    }
    // No leg changes faster than the platform moves, so the strokes bound the way from above.
    const double reach = coordinate < 3 ? 2.0 * limits.maxLength.maxCoeff() : std::numbers::pi / 2.0;
    return std::pair(limitOnTheWay(geometry, limits, pose, coordinate, -reach),
                     limitOnTheWay(geometry, limits, pose, coordinate, reach));
}

} // namespace hexapose
