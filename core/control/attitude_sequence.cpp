// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/control/attitude_sequence.h"

#include <utility>

namespace hexapose {

namespace {

/// Events after which the attitude will not be reached.
bool endsTheRun(EventCode code) {
    switch (code) {
    case EventCode::MoveRefused:
    case EventCode::CommandRefused:
    case EventCode::NotSettled:
    case EventCode::StopRequested:
    case EventCode::StoppedByController:
    case EventCode::StoppedOnStaleData:
    case EventCode::StoppedOnSolver:
    case EventCode::StoppedOnRefusal:
    case EventCode::StoppedOnFollowingError:
    case EventCode::StoppedOnNoEcho:
    case EventCode::StoppedOnLimits:
    case EventCode::StoppedOnNewIdentity:
    case EventCode::StoppedAfterLoss:
    case EventCode::ControllerFault:
    case EventCode::PreparationFailed:
    case EventCode::ClockWentBack:
    case EventCode::LinkLost:
    case EventCode::LoopFailed:
        return true;
    default:
        return false;
    }
}

} // namespace

AttitudeSequence::AttitudeSequence(std::vector<Pose> targets, std::chrono::nanoseconds dwell)
    : m_targets(std::move(targets)), m_dwell(dwell) {
    if (m_targets.empty())
        m_phase = Phase::Done;
}

std::optional<Pose> AttitudeSequence::add(const Snapshot& snapshot) {
    if (m_phase == Phase::Done || m_phase == Phase::Failed)
        return std::nullopt;
    if (m_phase == Phase::Waiting) {
        // Before the first Run: the controller must have said who it is and where the legs are.
        const bool ready = snapshot.link == LinkState::Connected && snapshot.measuredPose &&
                           !snapshot.stale && snapshot.state != RunState::Disconnected;
        if (!ready)
            return std::nullopt;
        m_phase = Phase::Moving;
        return m_targets[m_finished];
    }
    for (const Event& event : snapshot.events) {
        if (endsTheRun(event.code)) {
            m_phase = Phase::Failed;
            m_failure = event;
            return std::nullopt;
        }
        if (event.code == EventCode::Settled) {
            m_phase = Phase::Dwelling;
            m_since = snapshot.time;
        }
    }
    if (m_phase != Phase::Dwelling || snapshot.time - m_since < m_dwell)
        return std::nullopt;
    ++m_finished;
    if (m_finished == m_targets.size()) {
        m_phase = Phase::Done;
        return std::nullopt;
    }
    m_phase = Phase::Moving;
    return m_targets[m_finished];
}

} // namespace hexapose
