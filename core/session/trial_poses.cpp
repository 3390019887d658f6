// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/trial_poses.h"

#include "core/base/input_error.h"
#include "core/base/units.h"
#include "core/motion/leg_path_check.h"
#include "core/record/motion_check_words.h"
#include "core/report/error_report.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr std::uint64_t kSeed = 1;
constexpr double kOffsetRange = 0.010;
constexpr double kAngleRange = radiansFromDeg(10.0);
constexpr int kMostHalvings = 12;

Pose publishedPose() {
    PoseVector v;
    v << 0.012, -0.004, 0.040, 0.0, 0.0, radiansFromDeg(5.0);
    return Pose::fromVector(v);
}

} // namespace

std::vector<Pose> trialPoses(const PlatformModel& model, const PoseEnvelope& envelope, int more) {
    MotionLimits limits = motionLimits(model.geometry(), std::nullopt, std::nullopt);
    limits.envelope = envelope;
    if (const MotionCheck home = checkPose(model, limits, Pose{}); !home.ok())
        throw InputError(model.geometry().name, "home cannot be reached: " + toWords(home));
    const auto reachable = [&](const Pose& pose) { return checkLegPath(model, limits, Pose{}, pose).ok(); };
    for (int halvings = 0;; ++halvings) {
        try {
            std::vector<Pose> poses =
                randomPoses(model.geometry(), more + 1, std::ldexp(kOffsetRange, -halvings),
                            std::ldexp(kAngleRange, -halvings), kSeed);
            std::rotate(poses.begin(), poses.end() - 1, poses.end()); // the first one is for the move
            if (reachable(publishedPose()))
                poses.front() = publishedPose();
            if (std::all_of(poses.begin(), poses.end(), reachable))
                return poses;
        } catch (const InputError&) {
            if (halvings == kMostHalvings)
                throw;
        }
        if (halvings == kMostHalvings)
            throw InputError(model.geometry().name, "no pose near home can be reached");
    }
}

} // namespace hexapose
