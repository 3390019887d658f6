// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/platform_model.h"
#include "core/motion/path_timing.h"
#include "core/motion/pose_motion.h"

#include <optional>

namespace hexapose {

/// From one pose to another: straight in position, about one axis the shorter way round, in the shortest time
/// that the bounds allow. All of the motion's twists have the same direction.
class StraightMotion final : public PoseMotion {
public:
    /// bounds: complete ones. Both poses finite. Of no length: a motion that is over at once.
    StraightMotion(const PlatformModel& model, const Pose& from, const Pose& to, const MotionBounds& bounds)
        : StraightMotion(model, from, to, bounds, nullptr) {}
    /// The same, or nothing when the time is up before it is done.
    static std::optional<StraightMotion> plan(const PlatformModel& model, const Pose& from, const Pose& to,
                                              const MotionBounds& bounds, PlanTimer& timer);

    PoseReference at(double seconds) const override;
    double duration() const override { return m_timing ? m_timing->duration() : 0.0; }
    RateBounds rateBounds(const Eigen::Vector3d& p_PC_P) const override;

    const Pose& from() const { return m_from; }

private:
    StraightMotion(const PlatformModel& model, const Pose& from, const Pose& to, const MotionBounds& bounds,
                   PlanTimer* timer);

    Pose m_from;
    Pose m_to;
    Twist m_displacement;
    std::optional<PathTiming> m_timing;
};

} // namespace hexapose
