// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/limits.h"
#include "core/motion/plan_budget.h"

namespace hexapose {

/// The straight leg path from where the platform is, before it is begun: the target alone, then the pose
/// followed along the path in steps, the singularity margin at each, and the target reached at its end. A
/// step, of 1/100 of the path at most, is as short as it takes for the margin to hold all along it, to within
/// 0.0005. A timer that runs out ends the check with PlanTooLong and the fraction of the path that was
/// checked.
MotionCheck checkLegPath(const PlatformModel& model, const MotionLimits& limits, const Pose& from,
                         const Pose& to, PlanTimer* timer = nullptr);

} // namespace hexapose
