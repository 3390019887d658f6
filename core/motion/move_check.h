// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/limits.h"
#include "core/motion/plan_budget.h"

namespace hexapose {

// Whole motions, checked before they start. A timer that runs out ends a check with PlanTooLong and the
// fraction of the path that was checked; without one a check takes as long as it takes.

/// The straight leg path from where the platform is: the target alone, then the pose followed along the path
/// in steps, the singularity margin at each, and the target reached at its end. A step is as short as it
/// takes for the margin to hold between its ends too (1/100 of the path at most, 1/100000 at least).
MotionCheck checkLegPath(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& from,
                         const Pose& to, PlanTimer* timer = nullptr);

/// A motion in the workspace, whole: strokes, singularity margin, side and envelope, and the legs' speeds and
/// accelerations. It is looked at in 200 parts; a part is divided until the limits hold all along it, by the
/// most that anything can change there, or until it is 1/100000 of the machine's size. The first reason
/// along the path is told.
MotionCheck checkMotion(const PlatformGeometry& geometry, const MotionLimits& limits,
                        const PoseMotion& motion, PlanTimer* timer = nullptr);

} // namespace hexapose
