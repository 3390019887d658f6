// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"
#include "core/kinematics/platform_model.h"
#include "core/motion/motion_check.h"
#include "core/motion/pose_motion.h"

#include <limits>
#include <optional>
#include <string>

namespace hexapose {

/// How far the platform may go from home: along x, y, z (m), and in alpha, beta, gamma (rad).
struct PoseEnvelope {
    PoseVector furthest = PoseVector::Constant(std::numeric_limits<double>::infinity());
    bool operator==(const PoseEnvelope&) const = default;
};

/// What a pose or a move is checked against.
struct MotionLimits {
    LegLengths minLength = LegLengths::Zero(); ///< m
    LegLengths maxLength = LegLengths::Zero();
    double singularityMargin =
        0.05; ///< least allowed smallest singular value of the scaled Jacobian (no unit)
    /// Least allowed q, the determinant of the scaled Jacobian over that at home: 0 where the side is left.
    /// -infinity: not checked.
    double leastDeterminantRatio = 0.02;
    PoseEnvelope envelope;
    double legSpeed = std::numeric_limits<double>::infinity();        ///< m/s
    double legAcceleration = std::numeric_limits<double>::infinity(); ///< m/s^2
    bool operator==(const MotionLimits&) const = default;
};

/// Strokes of the platform, narrowed by the limits that the controller reports.
MotionLimits motionLimits(const PlatformGeometry& geometry, std::optional<double> controllerMin,
                          std::optional<double> controllerMax);

/// Leg lengths alone: finite, and in their strokes. Of several legs out of stroke the one furthest out is
/// named.
MotionCheck checkLegs(const MotionLimits& limits, const LegLengths& lengths);

/// The limits of a motion that begins with these lengths: a leg that is measured beyond an end of its stroke,
/// by no more than `within` (m), may be there, and goes no further.
MotionLimits limitsFrom(MotionLimits limits, const LegLengths& lengths, double within);

/// The pose alone: finite, strokes, singularity margin. Of several legs out of stroke the one furthest out is
/// named.
MotionCheck checkPose(const PlatformModel& model, const MotionLimits& limits, const Pose& pose);

/// The coordinate that is further from home than the envelope allows, or nothing.
std::optional<MotionCheck> outsideEnvelope(const PoseEnvelope& envelope, const Pose& pose);

} // namespace hexapose
