// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/move_judge.h"

#include "core/motion/motion_planner.h"

namespace hexapose {

MoveJudge::MoveJudge(const PlatformGeometry& geometry)
    : m_model(makeModel(geometry)), m_control(withDefaults(ControlOptions{}, geometry)),
      m_limits(motionLimits(geometry, {}, {})) {
    applyControl();
}

void MoveJudge::setControl(const ControlOptions& options) {
    m_control = withDefaults(options, geometry());
    applyControl();
}

void MoveJudge::follow(const Snapshot& snapshot) {
    m_limits = motionLimits(geometry(), snapshot.minLength, snapshot.maxLength);
    applyControl();
}

void MoveJudge::applyControl() {
    m_limits.envelope = m_control.envelope;
    m_limits.legSpeed = m_control.bounds.legSpeed;
    m_limits.legAcceleration = m_control.bounds.legAcceleration;
}

MotionLimits MoveJudge::limitsAt(const Pose& pose) const {
    return limitsFrom(m_limits, m_model->actuators(pose), m_control.settleWindow.distance);
}

MotionCheck MoveJudge::pose(const Pose& pose) const {
    return checkPose(*m_model, m_limits, pose);
}

MotionCheck MoveJudge::move(const Pose& from, const Pose& to, MotionMode mode) const {
    return planMotion(*m_model, m_control.bounds, m_limits, m_control.settleWindow.distance,
                      {m_model->actuators(from), from}, StraightMove{to, mode})
        .check;
}

} // namespace hexapose
