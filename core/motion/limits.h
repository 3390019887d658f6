// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"
#include "core/kinematics/forward_solver.h"
#include "core/motion/pose_motion.h"

#include <limits>
#include <optional>
#include <string>

namespace hexapose {

/// How far the platform may go from home: along x, y, z (m), and in alpha, beta, gamma (rad).
struct PoseEnvelope {
    PoseVector furthest = PoseVector::Constant(std::numeric_limits<double>::infinity());
};

/// What a pose or a move is judged against.
struct MotionLimits {
    LegLengths minLength = LegLengths::Zero(); ///< m
    LegLengths maxLength = LegLengths::Zero();
    double singularityMargin =
        0.05; ///< least allowed smallest singular value of the scaled Jacobian (no unit)
    /// Least allowed q, the determinant of the scaled Jacobian over that at home: 0 where the side is left.
    /// -infinity: not judged.
    double leastDeterminantRatio = 0.02;
    PoseEnvelope envelope;
    double legSpeed = std::numeric_limits<double>::infinity();        ///< m/s
    double legAcceleration = std::numeric_limits<double>::infinity(); ///< m/s^2
};

/// Strokes of the platform, narrowed by what the controller says of itself.
MotionLimits motionLimits(const PlatformGeometry& geometry, std::optional<double> controllerMin,
                          std::optional<double> controllerMax);

/// The judgement on a pose or a move, and why.
struct MotionCheck {
    enum class Reason {
        Ok,
        NotFinite,              ///< a coordinate is NaN or infinite
        LegAboveMax,            ///< leg, value, bound (m)
        LegBelowMin,            ///< leg, value, bound (m)
        NearSingular,           ///< value, bound: smallest singular value
        OtherAssemblyMode,      ///< the legs would lead to another pose than the target
        PathNearSingular,       ///< value, bound, fraction of the way
        OutsideEnvelope,        ///< axis, value, bound (m or rad)
        WrongSideOfSingularity, ///< value, bound: q, see MotionLimits
        LegSpeed,               ///< leg, value, bound (m/s), fraction of the way
        LegAcceleration,        ///< leg, value, bound (m/s^2), fraction of the way
    };
    Reason reason = Reason::Ok;
    int leg = 0; ///< 1..6, 0 when no leg is meant
    double value = 0.0;
    double bound = 0.0;
    double fraction = 1.0; ///< 0..1 of the way; below 1 the reason lies on the way and not at its end
    int axis = 0;          ///< 1..6: x y z alpha beta gamma; 0 when none is meant
    bool ok() const { return reason == Reason::Ok; }
};

/// Short stable words, as in the command line's contract: "ok", "leg 3 above max_mm", "leg 2 below min_mm",
/// "invalid-input", "near singular", "other branch", "path near singular at 63 %", "alpha outside the
/// envelope", "leg 4 too fast at 12 %".
std::string toWords(const MotionCheck& check);

/// Leg lengths alone: finite, and in their strokes. Of several legs out of stroke the one furthest out is
/// named.
MotionCheck checkLegs(const MotionLimits& limits, const LegLengths& lengths);

/// The limits of a motion that begins with these lengths: a leg that is measured beyond an end of its stroke,
/// by no more than `within` (m), may be there, and goes no further.
MotionLimits limitsFrom(MotionLimits limits, const LegLengths& lengths, double within);

/// The pose alone: finite, strokes, singularity margin. Of several legs out of stroke the one furthest out is
/// named.
MotionCheck checkPose(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& pose);

/// The coordinate that is further from home than the envelope allows, or nothing.
std::optional<MotionCheck> outsideEnvelope(const PoseEnvelope& envelope, const Pose& pose);

/// The straight leg path from where the platform is: the target alone, then the pose followed along the path
/// in steps, the singularity margin at each, and the target reached at its end. A step is as short as it
/// takes for the margin to hold between its ends too (1/100 of the way at most, 1/100000 at least).
MotionCheck checkLegPath(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& from,
                         const Pose& to);

/// A motion in the workspace, whole: strokes, singularity margin, side and envelope, and the legs' speeds and
/// accelerations. It is looked at in 200 parts; a part is divided until the limits hold all along it, by the
/// maxSpeed that anything can change there, or until it is 1/100000 of the machine's size. The first reason
/// on the way is told.
MotionCheck checkMotion(const PlatformGeometry& geometry, const MotionLimits& limits,
                        const PoseMotion& motion);

} // namespace hexapose
