// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/units.h"
#include "core/geometry/geometry_file.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/report/error_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace hexapose {

inline PlatformGeometry laboratory() {
    return loadPlatform(std::string(HEXAPOSE_SOURCE_DIR) + "/resources/platforms/laboratory.toml");
}

inline SettledSample sampleAt(const PlatformGeometry& geometry, const Pose& target) {
    SettledSample sample;
    sample.target = target;
    sample.meanLengths = legLengths(geometry, target);
    sample.measurements = 100;
    return sample;
}

/// What a controller would report that shows its lengths with this resolution (m).
inline SettledSample roundedSample(const PlatformGeometry& geometry, const Pose& target, double resolution) {
    SettledSample sample = sampleAt(geometry, target);
    sample.meanLengths = ((sample.meanLengths / resolution).array().round() * resolution).matrix();
    return sample;
}

inline std::vector<SettledSample> roundedSamples(const PlatformGeometry& geometry, int count,
                                                 double resolution) {
    std::vector<SettledSample> samples;
    for (const Pose& pose : randomPoses(geometry, count, 0.01, radiansFromDeg(10.0), 7))
        samples.push_back(roundedSample(geometry, pose, resolution));
    return samples;
}

} // namespace hexapose
