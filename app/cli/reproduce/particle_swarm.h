// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"

#include <cstdint>
#include <vector>

namespace hexapose::reproduce {

/// Particle swarm search with the constriction factor of Clerc and Kennedy, only to be compared with
/// (Front. Mech. Eng. 2025, 20(1):7, section 6). Fitness: root mean square of the differences of the legs.
struct SwarmOptions {
    int particles = 60;
    int iterations = 600;
    double offsetRange = 0.05; ///< of the box searched, +- m
    double angleRange = 0.8;   ///< +- rad
    std::uint64_t seed = 1;
};

/// The best pose so far after each iteration, the first entry before any.
std::vector<Pose> searchPose(const PlatformGeometry& platform, const LegLengths& lengths,
                             const SwarmOptions& options);

/// Root mean square of the leg differences, m.
double swarmFitness(const PlatformGeometry& platform, const LegLengths& lengths, const Pose& pose);

} // namespace hexapose::reproduce
