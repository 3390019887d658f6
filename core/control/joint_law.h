// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/control/motion_law.h"
#include "core/control/speed_ramp.h"
#include "core/control/trajectory.h"

namespace hexapose {

/// Joint mode: all legs on a straight path in their lengths, no matter where the platform is.
class JointLaw final : public MotionLaw {
public:
    /// legSpeed: m/s, of the fastest leg.
    JointLaw(const LegLengths& from, const LegLengths& to, double legSpeed);

    MotionMode mode() const override { return MotionMode::Joint; }
    LegLengths step(const Cycle& cycle) override;
    bool pathIsOver() const override;
    bool isThere(const LegLengths& lengths, const Pose& pose, const SettleWindow& window) const override;
    std::optional<PoseReference> reference() const override { return std::nullopt; }
    double duration() const override;

private:
    LegLengths m_to;
    LegTrajectory m_trajectory;
    SpeedRamp m_ramp;
    double m_pathTime = 0.0; ///< s
};

} // namespace hexapose
