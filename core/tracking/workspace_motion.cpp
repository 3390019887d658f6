// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/tracking/workspace_motion.h"

#include <utility>

namespace hexapose {

namespace {

constexpr double kStalledShare = 0.05; ///< of the operator's speed: a path that is slower does not go on
constexpr double kStallsAfter = 1.0;   ///< s

} // namespace

WorkspaceMotion::WorkspaceMotion(WorkspaceController& controller, std::shared_ptr<const PoseMotion> motion,
                                 WorkspaceController::Following following, const LegLengths& from)
    : m_controller(controller), m_motion(std::move(motion)), m_following(following), m_setPoint(from) {
    m_controller.begin(from);
}

LegLengths WorkspaceMotion::step(const Cycle& cycle) {
    m_waited += cycle.seconds;
    const double speed = m_ramp.step(cycle.speed, cycle.seconds);
    if (!cycle.lengths || !cycle.pose)
        return m_setPoint; // old data is no data: nothing is integrated on it
    const WorkspaceController::Step step = m_controller.step(
        {*cycle.lengths, *cycle.pose, m_waited}, m_motion->at(m_pathTime), m_following, speed, cycle.limits);
    m_pathTime += step.pathRate * m_waited;
    const bool goesOn = finished() || speed <= 0.0 || step.pathRate > kStalledShare * speed;
    m_stalled = goesOn ? 0.0 : m_stalled + m_waited;
    m_waited = 0.0;
    m_setPoint = step.setPoint;
    return m_setPoint;
}

bool WorkspaceMotion::stalls() const {
    return m_stalled >= kStallsAfter;
}

bool WorkspaceMotion::inPosition(const LegLengths&, const Pose& pose, const SettleWindow& window) const {
    return isWithin(window, pose, m_motion->at(m_motion->duration()).pose);
}

bool isWithin(const SettleWindow& window, const Pose& pose, const Pose& end) {
    const Twist error = displacement(pose, end);
    return error.head<3>().norm() <= window.distance && error.tail<3>().norm() <= window.angle;
}

} // namespace hexapose
