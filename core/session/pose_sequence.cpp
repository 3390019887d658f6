// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/pose_sequence.h"

#include <utility>

namespace hexapose {

PoseSequence::PoseSequence(std::vector<Pose> targets, std::chrono::nanoseconds dwell)
    : m_targets(std::move(targets)), m_dwell(dwell) {
    if (m_targets.empty())
        m_phase = Phase::Done;
}

/// Whether the attitude will not be reached after this.
bool PoseSequence::ends(const Event& event) const {
    switch (event.code) {
    case EventCode::NotSettled:
    case EventCode::StopRequested:
    case EventCode::JogStarted:
        return true;
    case EventCode::MoveStarted:
        return !m_asked; // somebody else's
    case EventCode::MoveRefused:
    case EventCode::PreparationFailed:
        return m_asked;
    case EventCode::CommandRefused:
        return m_asked && event.get<CommandRefusal>() && event.get<CommandRefusal>()->command == Command::Run;
    default:
        return isFault(event.code);
    }
}

std::optional<Pose> PoseSequence::add(const Snapshot& snapshot) {
    if (m_phase == Phase::Done || m_phase == Phase::Failed)
        return std::nullopt;
    if (m_phase == Phase::Waiting) {
        // Before the first Run: the controller must have said who it is and where the legs are.
        const bool ready = snapshot.link == LinkState::Connected && snapshot.measuredPose &&
                           !snapshot.stale && snapshot.state != RunState::Disconnected;
        if (!ready)
            return std::nullopt;
        m_phase = Phase::Moving;
        m_asked = true;
        return m_targets[m_finished];
    }
    for (const Event& event : snapshot.events) {
        if (ends(event)) {
            m_phase = Phase::Failed;
            m_failure = event;
            return std::nullopt;
        }
        if (event.code == EventCode::MoveStarted) {
            m_asked = false;
            ++m_begun;
        }
        if (event.code == EventCode::Settled && !m_asked) {
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
    m_asked = true;
    return m_targets[m_finished];
}

} // namespace hexapose
