// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/tracking/motion_generator.h"
#include "core/tracking/speed_ramp.h"
#include "core/tracking/workspace_controller.h"

#include <memory>

namespace hexapose {

/// Workspace mode: a planned motion, led by the pose that is measured. After its end the pose is held.
class WorkspaceMotion final : public MotionGenerator {
public:
    /// controller: outlives the motion, and keeps what it learned for the next one. from: set-point in force.
    WorkspaceMotion(WorkspaceController& controller, std::shared_ptr<const PoseMotion> motion,
                    WorkspaceController::Following following, const LegLengths& from);

    MotionMode mode() const override { return MotionMode::Workspace; }
    LegLengths step(const Cycle& cycle) override;
    bool finished() const override { return m_pathTime >= m_motion->duration(); }
    bool inPosition(const LegLengths& lengths, const Pose& pose, const SettleWindow& window) const override;
    std::optional<PoseReference> reference() const override { return m_motion->at(m_pathTime); }
    double duration() const override { return m_motion->duration(); }
    bool stalls() const override;

private:
    WorkspaceController& m_controller;
    std::shared_ptr<const PoseMotion> m_motion;
    WorkspaceController::Following m_following;
    LegLengths m_setPoint;
    SpeedRamp m_ramp;
    double m_pathTime = 0.0; ///< s
    double m_waited = 0.0;   ///< s, since the last measurement
    double m_stalled = 0.0;  ///< s, for which the path has hardly gone on
};

/// Whether two poses are within the window.
bool isWithin(const SettleWindow& window, const Pose& pose, const Pose& end);

} // namespace hexapose
