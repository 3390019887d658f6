// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/pose_sequence.h"

#include <utility>

namespace hexapose {

namespace {

/// Events after which the attitude will not be reached.
bool endsTheRun(EventCode code) {
    return isFault(code) || code == EventCode::MoveRefused || code == EventCode::CommandRefused ||
           code == EventCode::NotSettled || code == EventCode::StopRequested ||
           code == EventCode::PreparationFailed;
}

} // namespace

PoseSequence::PoseSequence(std::vector<Pose> targets, std::chrono::nanoseconds dwell)
    : m_targets(std::move(targets)), m_dwell(dwell) {
    if (m_targets.empty())
        m_phase = Phase::Done;
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
