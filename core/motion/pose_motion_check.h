// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/limits.h"
#include "core/motion/plan_budget.h"
#include "core/motion/pose_motion.h"

namespace hexapose {

/// A motion in the workspace, whole, before it is begun: strokes, singularity margin, side and envelope, and
/// the legs' speeds and accelerations. It is looked at in 200 parts; a part is divided until the limits hold
/// all along it, by the most that anything can change there (the margin to within 0.0005), or until it is
/// 1/100000 of the machine's size. Returns the first violation along the path. A timer that runs out ends the
/// check with PlanTooLong and the fraction of the path that was checked.
MotionCheck checkMotion(const PlatformModel& model, const MotionLimits& limits, const PoseMotion& motion,
                        PlanTimer* timer = nullptr);

} // namespace hexapose
