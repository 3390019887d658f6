// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hexapose {

/// What a check of a pose or of a whole motion found: nothing, or the first violation along the path.
struct MotionCheck {
    enum class Reason {
        Ok,
        NotFinite,              ///< a coordinate is NaN or infinite
        LegAboveMax,            ///< leg, value, bound (m)
        LegBelowMin,            ///< leg, value, bound (m)
        NearSingular,           ///< value, bound: smallest singular value
        OtherAssemblyMode,      ///< the legs would lead to another pose than the target
        PathNearSingular,       ///< value, bound, fraction of the path
        OutsideEnvelope,        ///< axis, value, bound (m or rad)
        WrongSideOfSingularity, ///< value, bound: q, see MotionLimits
        LegSpeed,               ///< leg, value, bound (m/s), fraction of the path
        LegAcceleration,        ///< leg, value, bound (m/s^2), fraction of the path
        PlanTooLong,            ///< the time for planning was used up; fraction of the path that was checked
        StartMoved,             ///< the platform has left the start of the planned motion
        LimitsChanged,          ///< the limits are not those of the plan any more
    };
    Reason reason = Reason::Ok;
    int leg = 0;           ///< 1..6, 0 when no leg is meant
    double value = 0.0;    ///< NaN when only the reason is known, as from a log
    double bound = 0.0;    ///< NaN likewise
    double fraction = 1.0; ///< 0..1 of the path; below 1 the violation lies along it and not at its end
    int axis = 0;          ///< 1..6: x y z alpha beta gamma; 0 when none is meant
    bool ok() const { return reason == Reason::Ok; }
    /// Whether the violation lies along the path, while the target itself may be reached.
    bool liesAlongPath() const { return fraction < 1.0 || reason == Reason::PathNearSingular; }
};

} // namespace hexapose
