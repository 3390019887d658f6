// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/jog.h"
#include "core/tracking/motion_generator.h"
#include "core/tracking/workspace_controller.h"

namespace hexapose {

/// A jog: the reference goes on in one direction while it is held, and comes to rest when it is released, or
/// before a limit, in good time: what it would take to come to rest is checked in every cycle.
class JogMotion final : public MotionGenerator {
public:
    /// from: set-point in force; at: measured pose. bounds: complete.
    JogMotion(WorkspaceController& controller, SharedModel model, const MotionBounds& bounds,
              const LegLengths& from, const Pose& at);

    /// Held, or held on. speedOverride: 0..1 of full speed. Another direction than before: comes to rest
    /// first.
    void hold(const JogDirection& direction, double speedOverride);
    void release() { m_held = false; }

    MotionMode mode() const override { return MotionMode::Workspace; }
    LegLengths step(const Cycle& cycle) override;
    bool finished() const override { return !m_held && m_pace == 0.0 && m_acceleration == 0.0; }
    bool inPosition(const LegLengths& lengths, const Pose& pose, const SettleWindow& window) const override;
    std::optional<PoseReference> reference() const override;
    double duration() const override { return 0.0; }
    std::optional<Event> takeEvent() override;

private:
    struct Limits {
        double pace, acceleration, jerk; ///< m or rad, s
    };
    Limits limits() const;
    double wantedPace(const Cycle& cycle);
    void changePace(double wanted, double seconds);

    WorkspaceController& m_controller;
    SharedModel m_model;
    MotionBounds m_bounds;
    LegLengths m_setPoint;
    Pose m_reference;
    JogDirection m_direction;
    JogDirection m_wanted;
    double m_override = 0.0;
    bool m_held = false;
    bool m_blocked = false;      ///< a limit ended it; until it is pressed anew
    double m_pace = 0.0;         ///< m/s or rad/s along the direction
    double m_acceleration = 0.0; ///< of the pace
    double m_waited = 0.0;       ///< s, since the last measurement
    std::optional<Event> m_event;
};

} // namespace hexapose
