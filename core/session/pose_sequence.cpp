// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/pose_sequence.h"

#include <algorithm>
#include <utility>

namespace hexapose {

namespace {

bool isRefusalOf(MotionId id, const Event& event) {
    const auto* refusal = event.get<CommandRefusal>();
    return event.code == EventCode::CommandRefused && refusal && refusal->id == id;
}

} // namespace

PoseSequence::PoseSequence(std::vector<Pose> targets, std::chrono::nanoseconds dwell, MotionId firstId)
    : m_targets(std::move(targets)), m_dwell(dwell), m_firstId(firstId) {
    if (m_targets.empty())
        m_phase = Phase::Done;
}

std::optional<Pose> PoseSequence::ask(const Snapshot& snapshot) {
    m_phase = Phase::Moving;
    m_idBefore = snapshot.motionId;
    m_answered = m_taken = m_started = false;
    return m_targets[m_finished];
}

/// Whether the pose will not be reached after this.
bool PoseSequence::endsTheRun(const Event& event) const {
    switch (event.code) {
    case EventCode::NotSettled:
    case EventCode::StopRequested:
        return true;
    case EventCode::MoveRefused:
    case EventCode::PreparationFailed:
        return !m_started; // nobody else's Run can be pending beside ours
    case EventCode::CommandRefused:
        return isRefusalOf(id(), event);
    default:
        return isFault(event.code);
    }
}

/// Why the present Run is over before its time, if it is.
std::optional<Event> PoseSequence::end(const Snapshot& snapshot) {
    const bool ours = snapshot.motionId == id();
    if (ours && !m_taken) {
        m_taken = m_answered = true;
        ++m_accepted;
    }
    for (const Event& event : snapshot.events) {
        m_started = m_started || (ours && event.code == EventCode::MoveStarted);
        if (endsTheRun(event))
            return event;
    }
    if (!ours && (m_taken || snapshot.motionId != m_idBefore)) {
        const auto& events = snapshot.events;
        const bool jog = std::any_of(events.begin(), events.end(),
                                     [](const Event& e) { return e.code == EventCode::JogStarted; });
        return Event{jog ? EventCode::JogStarted : EventCode::MoveStarted};
    }
    // Dropped without a word, as a Disable drops what is pending.
    const bool free = snapshot.allowed.contains(Command::Run);
    if (m_answered && !m_started && free)
        return Event{EventCode::CommandRefused,
                     CommandRefusal{Command::Run, snapshot.state, snapshot.allowed, id()}};
    m_answered = m_answered || !free;
    return std::nullopt;
}

std::optional<Pose> PoseSequence::add(const Snapshot& snapshot) {
    if (m_phase == Phase::Done || m_phase == Phase::Failed)
        return std::nullopt;
    if (m_phase == Phase::Waiting) {
        // Before the first Run: the controller must have said who it is and where the legs are.
        const bool ready = snapshot.link == LinkState::Connected && snapshot.measuredPose &&
                           !snapshot.stale && snapshot.state != RunState::Disconnected;
        return ready ? ask(snapshot) : std::nullopt;
    }
    if (std::optional<Event> why = end(snapshot)) {
        m_phase = Phase::Failed;
        m_failure = std::move(why);
        return std::nullopt;
    }
    for (const Event& event : snapshot.events) {
        if (event.code == EventCode::Settled && m_started) {
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
    return ask(snapshot);
}

} // namespace hexapose
