// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/input_error.h"
#include "core/base/units.h"
#include "core/kinematics/platform_model.h"
#include "core/report/error_report.h"

#include <cmath>
#include <random>

namespace hexapose {

namespace {

/// Smallest singular value of the scaled Jacobian below which a move may be refused.
constexpr double kSingularityMargin = 0.05;
/// The strokes may leave little of a wide range; when it is less than one in so many, the range is the
/// mistake.
constexpr int kDrawsPerPose = 10000;

constexpr double kDefaultOffsetRange = 0.010;
constexpr double kDefaultAngleRange = radiansFromDeg(10.0);
constexpr int kMostHalvings = 12;

/// Uniform in [-1, 1). The library's distributions differ between implementations; a seed should not.
double symmetricUnit(std::mt19937_64& random) {
    return std::ldexp(static_cast<double>(random() >> 11U), -52) - 1.0;
}

bool isReachable(const PlatformModel& model, const Pose& pose) {
    const LegLengths lengths = model.actuators(pose);
    return (lengths.array() >= model.minActuators().array()).all() &&
           (lengths.array() <= model.maxActuators().array()).all() &&
           model.singularity(pose).smallestSingularValue >= kSingularityMargin;
}

} // namespace

std::vector<Pose> randomPoses(const PlatformGeometry& geometry, int count, double offsetRange,
                              double angleRange, std::uint64_t seed) {
    const auto isRange = [](double range) { return std::isfinite(range) && range >= 0.0; };
    if (!isRange(offsetRange) || !isRange(angleRange))
        throw InputError("attitudes", "a range is negative or not finite");
    const PlatformModel model(geometry);
    std::mt19937_64 random(seed);
    std::vector<Pose> poses;
    for (int i = 0; i < count; ++i) {
        int draws = 0;
        Pose pose;
        do {
            if (++draws > kDrawsPerPose)
                throw InputError("attitudes",
                                 "the strokes of " + geometry.name + " leave nothing of the range asked for");
            PoseVector v;
            for (int k = 0; k < 6; ++k)
                v[k] = symmetricUnit(random) * (k < 3 ? offsetRange : angleRange);
            pose = Pose::fromVector(v);
        } while (!isReachable(model, pose));
        poses.push_back(pose);
    }
    return poses;
}

std::vector<Pose> defaultPoses(const PlatformGeometry& geometry, int count, std::uint64_t seed) {
    for (int halvings = 0;; ++halvings) {
        try {
            return randomPoses(geometry, count, std::ldexp(kDefaultOffsetRange, -halvings),
                               std::ldexp(kDefaultAngleRange, -halvings), seed);
        } catch (const InputError&) {
            if (halvings == kMostHalvings)
                throw;
        }
    }
}

} // namespace hexapose
