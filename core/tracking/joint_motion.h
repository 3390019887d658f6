// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/leg_trajectory.h"
#include "core/tracking/motion_generator.h"
#include "core/tracking/speed_ramp.h"

namespace hexapose {

/// Joint mode: all legs on a straight path in their lengths, no matter where the platform is.
class JointMotion final : public MotionGenerator {
public:
    /// legSpeed: m/s, of the fastest leg.
    JointMotion(const LegLengths& from, const LegLengths& to, double legSpeed);

    MotionMode mode() const override { return MotionMode::Joint; }
    LegLengths step(const Cycle& cycle) override;
    bool finished() const override;
    bool inPosition(const LegLengths& lengths, const Pose& pose, const SettleWindow& window) const override;
    std::optional<PoseReference> reference() const override { return std::nullopt; }
    double duration() const override;

private:
    LegLengths m_to;
    LegTrajectory m_trajectory;
    SpeedRamp m_ramp;
    double m_pathTime = 0.0; ///< s
};

} // namespace hexapose
