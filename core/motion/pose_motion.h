// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"
#include "core/geometry/twist.h"

namespace hexapose {

/// Limits of a motion in the workspace. A number that is 0 is filled in by withDefaults().
struct MotionBounds {
    double speed = 0.0;               ///< of P, m/s
    double acceleration = 0.0;        ///< m/s^2
    double jerk = 0.0;                ///< m/s^3
    double angularSpeed = 0.0;        ///< rad/s
    double angularAcceleration = 0.0; ///< rad/s^2
    double angularJerk = 0.0;         ///< rad/s^3
    double legSpeed = 0.0;            ///< of each leg, m/s
    double legAcceleration = 0.0;     ///< of each leg, m/s^2
    bool operator==(const MotionBounds&) const = default;
};

/// What is not given, from the machine: a stroke in 2.5 s (at most 80 mm/s) for legs and P, turning as fast
/// as that at the joints; full speed after 0.25 s, full acceleration after 0.1 s.
MotionBounds withDefaults(MotionBounds bounds, const PlatformGeometry& geometry);

/// Where the platform should be at a time, and how it should move there.
struct PoseReference {
    Pose pose;
    Twist twist = Twist::Zero(); ///< m/s and rad/s, base frame
};

/// Upper bounds, at any time of a motion, for a point C that is fixed to the platform and for its turning:
/// magnitudes of vectors.
struct RateBounds {
    double speed = 0.0;               ///< of C, m/s
    double acceleration = 0.0;        ///< of C, m/s^2
    double angularSpeed = 0.0;        ///< rad/s
    double angularAcceleration = 0.0; ///< rad/s^2
};

/// A motion in the workspace over its own time, from rest to rest. Immutable.
class PoseMotion {
public:
    virtual ~PoseMotion() = default;
    virtual PoseReference at(double seconds) const = 0; ///< before 0 as at 0, after the end as at the end
    virtual double duration() const = 0;                ///< s
    /// What lies between two samples of the motion is checked by these.
    virtual RateBounds rateBounds(const Eigen::Vector3d& p_PC_P) const = 0;
};

} // namespace hexapose
