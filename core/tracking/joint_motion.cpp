// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/tracking/joint_motion.h"

namespace hexapose {

namespace {

std::chrono::nanoseconds nanoseconds(double seconds) {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
}

} // namespace

JointMotion::JointMotion(const LegLengths& from, const LegLengths& to, double legSpeed)
    : m_to(to), m_trajectory(from, to, legSpeed) {}

LegLengths JointMotion::step(const Cycle& cycle) {
    m_pathTime += m_ramp.step(cycle.speed, cycle.seconds) * cycle.seconds;
    return m_trajectory.at(nanoseconds(m_pathTime));
}

bool JointMotion::finished() const {
    return m_pathTime >= duration();
}

bool JointMotion::inPosition(const LegLengths& lengths, const Pose&, const SettleWindow& window) const {
    return (lengths - m_to).cwiseAbs().maxCoeff() <= window.distance;
}

double JointMotion::duration() const {
    return std::chrono::duration<double>(m_trajectory.duration()).count();
}

} // namespace hexapose
