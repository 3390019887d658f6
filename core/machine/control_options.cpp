// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/control_options.h"

#include <algorithm>

namespace hexapose {

namespace {

constexpr double kSettleWindow = 2e-4;       ///< m
constexpr double kSettleOfStroke = 2e-3;     ///< for machines with small strokes,
constexpr double kSettleRounding = 1e-4;     ///< m, but no less than a length is commonly rounded to,
constexpr double kSettleMostOfStroke = 0.02; ///< unless that is much of the stroke
/// Largest distance of a leg from its set-point, of the machine's size: 24 mm for the laboratory platform,
/// whose legs lag by 10 mm at most.
constexpr double kFollowingOfSize = 0.08;
constexpr double kOrdinaryLag = 0.3; ///< s; a machine of long strokes for its size may lag further

} // namespace

ControlOptions withDefaults(ControlOptions options, const PlatformGeometry& geometry) {
    options.bounds = withDefaults(options.bounds, geometry);
    double stroke = 0.0;
    for (const Leg& leg : geometry.legs)
        stroke += (leg.maxLength - leg.minLength) / kLegCount;
    if (options.settleWindow.distance <= 0.0)
        options.settleWindow.distance =
            std::min(kSettleWindow, std::max(kSettleOfStroke * stroke,
                                             std::min(kSettleRounding, kSettleMostOfStroke * stroke)));
    if (options.settleWindow.angle <= 0.0)
        options.settleWindow.angle = options.settleWindow.distance / geometry.jointRadius();
    if (options.followingLimit <= 0.0)
        options.followingLimit =
            std::max(kFollowingOfSize * geometry.size(), kOrdinaryLag * options.bounds.legSpeed);
    return options;
}

MotionPlanner::Settings plannerSettings(const ControlOptions& options, const PlatformGeometry& geometry) {
    const ControlOptions complete = withDefaults(options, geometry);
    return {complete.bounds, complete.envelope, complete.settleWindow.distance};
}

} // namespace hexapose
