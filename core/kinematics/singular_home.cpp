// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/singular_home.h"

#include "core/geometry/likely_cause.h"
#include "core/kinematics/singularity.h"

#include <cmath>

namespace hexapose {

namespace {

/// Smallest singular value that a move must keep (MotionLimits): below it nothing can begin at home.
constexpr double kLeast = 0.05;
constexpr double kSingular = 1e-9;

double smallestAtHome(const PlatformGeometry& geometry) {
    return singularityMeasure(geometry, Pose{}).smallestSingularValue;
}

bool isSound(const PlatformGeometry& geometry) {
    return findFaults(geometry).empty() && smallestAtHome(geometry) >= kLeast;
}

} // namespace

std::optional<std::string> faultOfHome(const PlatformGeometry& geometry) {
    const double smallest = smallestAtHome(geometry);
    if (smallest >= kLeast)
        return std::nullopt;
    const std::string text = smallest > kSingular ? "its geometry is too close to singular at home"
                                                  : "its geometry is singular at home";
    if (areSimilarFigures(geometry))
        return text + ": base and platform joints form similar figures";
    const std::string mistake = likelyMistake(geometry, isSound);
    return mistake.empty() ? text : text + "; likely cause: " + mistake;
}

} // namespace hexapose
