// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/tracking/jog_motion.h"

#include "core/tracking/workspace_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexapose {

namespace {

constexpr int kLooksAhead = 4;          ///< poses on the path to rest that are checked
constexpr double kBrakingReserve = 1.2; ///< of that distance
/// A jog may begin with a leg so far beyond the end of its stroke, of the machine's size: measured, not led
/// there.
constexpr double kBeyondOfSize = 1e-3;
constexpr double kStandstill = 1e-3; ///< of full pace: less is none

} // namespace

JogMotion::JogMotion(WorkspaceController& controller, SharedModel model, const MotionBounds& bounds,
                     const LegLengths& from, const Pose& at)
    : m_controller(controller), m_model(std::move(model)), m_bounds(bounds), m_setPoint(from),
      m_reference(at) {
    m_controller.begin(from);
}

void JogMotion::hold(const JogDirection& direction, double speedOverride) {
    if (!m_held || direction != m_wanted)
        m_blocked = false;
    m_held = true;
    m_wanted = direction;
    m_override = std::clamp(speedOverride, 0.0, 1.0);
}

JogMotion::Limits JogMotion::limits() const {
    if (m_direction.axis < 3)
        return {m_bounds.speed, m_bounds.acceleration, m_bounds.jerk};
    return {m_bounds.angularSpeed, m_bounds.angularAcceleration, m_bounds.angularJerk};
}

/// 0 where the path to rest, begun a moment later, would leave the limits.
double JogMotion::wantedPace(const Cycle& cycle) {
    const Limits most = limits();
    if (!m_held || m_blocked || m_direction != m_wanted)
        return 0.0;
    const Twist unit = unitTwist(m_direction, m_reference);
    const double legRate = (m_model->jacobian(m_reference) * unit).cwiseAbs().maxCoeff();
    const double full = std::min(most.pace, m_bounds.legSpeed / std::max(legRate, 1e-9));
    const double pace = full * m_override * cycle.speed;
    const double faster =
        std::max(m_pace, 0.0) + std::max(m_acceleration, 0.0) * most.acceleration / most.jerk;
    const double distance =
        kBrakingReserve * (0.5 * faster * faster / most.acceleration +
                           faster * (most.acceleration / most.jerk + 2.0 * cycle.seconds));
    const LegLengths here = m_model->actuators(m_reference);
    const MotionLimits bounds = limitsFrom(cycle.limits, here, kBeyondOfSize * m_model->size());
    for (int k = 1; k <= kLooksAhead; ++k) {
        const Pose ahead =
            displaced(m_reference, (distance * k / kLooksAhead + kStandstill * full * cycle.seconds) * unit);
        const MotionCheck check = checkPose(*m_model, bounds, ahead);
        if (check.ok())
            continue;
        m_blocked = true;
        m_event = Event{EventCode::JogLimited, check};
        return 0.0;
    }
    return pace;
}

/// Towards the wanted pace, with limited acceleration and jerk.
void JogMotion::changePace(double wanted, double seconds) {
    if (seconds <= 0.0)
        return;
    const Limits most = limits();
    const double missing = wanted - m_pace;
    // The largest acceleration that jerk can still take away before the pace is reached, in cycles: taken
    // down by `part` a cycle, over steps + 1 of them, it adds up to what is missing.
    const double part = most.jerk * seconds;
    const double parts = std::abs(missing) / (part * seconds);
    const double steps = std::floor(0.5 * (std::sqrt(1.0 + 8.0 * parts) - 1.0));
    const double swing = part * (parts / (steps + 1.0) + 0.5 * steps);
    const double aim = std::copysign(std::min(most.acceleration, swing), missing);
    m_acceleration += std::clamp(aim - m_acceleration, -most.jerk * seconds, most.jerk * seconds);
    m_pace = std::max(m_pace + m_acceleration * seconds, 0.0);
    if (wanted == 0.0 && m_pace <= kStandstill * most.pace)
        m_pace = m_acceleration = 0.0;
}

LegLengths JogMotion::step(const Cycle& cycle) {
    m_waited += cycle.seconds;
    if (!cycle.lengths || !cycle.pose)
        return m_setPoint;
    if (m_pace == 0.0)
        m_direction = m_wanted;
    changePace(wantedPace(cycle), m_waited);
    const WorkspaceController::Step step =
        m_controller.step({*cycle.lengths, *cycle.pose, m_waited}, *reference(),
                          WorkspaceController::Following::Time, 1.0, cycle.limits);
    m_reference =
        displaced(m_reference, step.pathRate * m_waited * m_pace * unitTwist(m_direction, m_reference));
    m_waited = 0.0;
    m_setPoint = step.setPoint;
    return m_setPoint;
}

bool JogMotion::inPosition(const LegLengths&, const Pose& pose, const SettleWindow& window) const {
    return isWithin(window, pose, m_reference);
}

std::optional<PoseReference> JogMotion::reference() const {
    return PoseReference{m_reference, m_pace * unitTwist(m_direction, m_reference)};
}

std::optional<Event> JogMotion::takeEvent() {
    return std::exchange(m_event, std::nullopt);
}

} // namespace hexapose
