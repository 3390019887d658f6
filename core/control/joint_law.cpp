// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/control/joint_law.h"

namespace hexapose {

namespace {

std::chrono::nanoseconds nanoseconds(double seconds) {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
}

} // namespace

JointLaw::JointLaw(const LegLengths& from, const LegLengths& to, double legSpeed)
    : m_to(to), m_trajectory(from, to, legSpeed) {}

LegLengths JointLaw::step(const Cycle& cycle) {
    m_pathTime += m_ramp.step(cycle.speed, cycle.seconds) * cycle.seconds;
    return m_trajectory.at(nanoseconds(m_pathTime));
}

bool JointLaw::pathIsOver() const {
    return m_pathTime >= duration();
}

bool JointLaw::isThere(const LegLengths& lengths, const Pose&, const SettleWindow& window) const {
    return (lengths - m_to).cwiseAbs().maxCoeff() <= window.distance;
}

double JointLaw::duration() const {
    return std::chrono::duration<double>(m_trajectory.duration()).count();
}

} // namespace hexapose
