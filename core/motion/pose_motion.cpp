// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/pose_motion.h"

#include <algorithm>

namespace hexapose {

namespace {

constexpr double kStrokeSeconds = 2.5;      ///< mean stroke in so long
constexpr double kFastestLeg = 0.08;        ///< m/s, below what the drives can do
constexpr double kToFullSpeed = 0.25;       ///< s
constexpr double kToFullAcceleration = 0.1; ///< s
constexpr double kLegMargin = 4.0;          ///< of the legs' acceleration over that of P

void fill(double& number, double value) {
    if (!(number > 0.0))
        number = value;
}

} // namespace

MotionBounds withDefaults(MotionBounds bounds, const PlatformGeometry& geometry) {
    double stroke = 0.0;
    for (const Leg& leg : geometry.legs)
        stroke += (leg.maxLength - leg.minLength) / kLegCount;
    fill(bounds.legSpeed, std::min(stroke / kStrokeSeconds, kFastestLeg));
    fill(bounds.speed, bounds.legSpeed);
    fill(bounds.angularSpeed, bounds.legSpeed / geometry.jointRadius());
    fill(bounds.acceleration, bounds.speed / kToFullSpeed);
    fill(bounds.angularAcceleration, bounds.angularSpeed / kToFullSpeed);
    fill(bounds.jerk, bounds.acceleration / kToFullAcceleration);
    fill(bounds.angularJerk, bounds.angularAcceleration / kToFullAcceleration);
    fill(bounds.legAcceleration, kLegMargin * bounds.legSpeed / kToFullSpeed);
    return bounds;
}

} // namespace hexapose
