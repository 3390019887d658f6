// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/pose.h"
#include "core/kinematics/platform_model.h"
#include "core/motion/limits.h"

#include <vector>

namespace hexapose {

/// For a trial of any platform: the pose of the published test, or another where the platform cannot go
/// there, and after it `more` poses, always the same. All of them can be reached from home. Throws
/// InputError, with the cause, for a platform that can reach none.
std::vector<Pose> trialPoses(const PlatformModel& model, const PoseEnvelope& envelope, int more);

} // namespace hexapose
