// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/move_judge.h"

#include "core/kinematics/inverse_kinematics.h"
#include "core/motion/leg_path_check.h"
#include "core/motion/pose_motion_check.h"
#include "core/motion/straight_motion.h"

namespace hexapose {

MoveJudge::MoveJudge(const PlatformGeometry& geometry)
    : m_geometry(geometry), m_control(withDefaults(ControlOptions{}, geometry)),
      m_limits(motionLimits(geometry, {}, {})) {
    applyControl();
}

void MoveJudge::setControl(const ControlOptions& options) {
    m_control = withDefaults(options, m_geometry);
    applyControl();
}

void MoveJudge::follow(const Snapshot& snapshot) {
    m_limits = motionLimits(m_geometry, snapshot.minLength, snapshot.maxLength);
    applyControl();
}

void MoveJudge::applyControl() {
    m_limits.envelope = m_control.envelope;
    m_limits.legSpeed = m_control.bounds.legSpeed;
    m_limits.legAcceleration = m_control.bounds.legAcceleration;
}

MotionLimits MoveJudge::limitsAt(const Pose& pose) const {
    return limitsFrom(m_limits, legLengths(m_geometry, pose), m_control.settleWindow.distance);
}

MotionCheck MoveJudge::pose(const Pose& pose) const {
    return checkPose(m_geometry, m_limits, pose);
}

MotionCheck MoveJudge::move(const Pose& from, const Pose& to, MotionMode mode) const {
    if (mode == MotionMode::Joint) {
        return checkLegPath(m_geometry, m_limits, from, to);
    }
    // A target that cannot be is not worth a plan.
    MotionCheck check = checkPose(m_geometry, m_limits, to);
    if (check.ok() && !from.isFinite()) {
        check.reason = MotionCheck::Reason::NotFinite;
    }
    return check.ok() ? checkMotion(m_geometry, limitsAt(from),
                                    StraightMotion(m_geometry, from, to, m_control.bounds))
                      : check;
}

} // namespace hexapose
