// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"
#include "core/kinematics/forward_solver.h"

#include <optional>
#include <string>

namespace hexapose {

/// What a pose or a move is judged against.
struct MotionLimits {
    LegLengths minLength = LegLengths::Zero(); ///< m
    LegLengths maxLength = LegLengths::Zero();
    double singularityMargin =
        0.05; ///< least allowed smallest singular value of the scaled Jacobian (no unit)
};

/// Strokes of the platform, narrowed by what the controller says of itself.
MotionLimits motionLimits(const PlatformGeometry& geometry, std::optional<double> controllerMin,
                          std::optional<double> controllerMax);

/// The judgement on a pose or a move, and why.
struct Verdict {
    enum class Reason {
        Ok,
        NotFinite,        ///< a coordinate is NaN or infinite
        LegAboveMax,      ///< leg, value, bound (m)
        LegBelowMin,      ///< leg, value, bound (m)
        NearSingular,     ///< value, bound: smallest singular value
        OtherBranch,      ///< the legs would lead to another pose than the target
        PathNearSingular, ///< value, bound, fraction of the way
    };
    Reason reason = Reason::Ok;
    int leg = 0; ///< 1..6, 0 when no leg is meant
    double value = 0.0;
    double bound = 0.0;
    double fraction = 1.0; ///< 0..1 of the way, for path reasons
    bool ok() const { return reason == Reason::Ok; }
};

/// Short stable words, as in the command line's contract: "ok", "leg 3 above max_mm", "leg 2 below min_mm",
/// "invalid-input", "near singular", "other branch", "path near singular at 63 %".
std::string toWords(const Verdict& verdict);

/// Leg lengths alone: finite, and in their strokes. Of several legs out of stroke the one furthest out is
/// named.
Verdict checkLegs(const MotionLimits& limits, const LegLengths& lengths);

/// The pose alone: finite, strokes, singularity margin. Of several legs out of stroke the one furthest out is
/// named.
Verdict checkPose(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& pose);

/// The straight leg path from where the platform is: the target alone, then the pose followed along the path
/// in `steps` steps, the singularity margin at each, and the target reached at its end.
Verdict checkLegPath(const PlatformGeometry& geometry, const MotionLimits& limits, const Pose& from,
                     const Pose& to, int steps = 100);

} // namespace hexapose
