// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/visit_job.h"

#include <utility>

namespace hexapose {

namespace {

/// How soon an interruption is noticed when no cycle comes.
constexpr std::chrono::milliseconds kLookEvery{50};

} // namespace

VisitJob::VisitJob(std::vector<Pose> targets, const Options& options)
    : m_options(options), m_sequence(std::move(targets), kSampleDwell) {}

bool VisitJob::isOver() const {
    return m_failure || m_sequence.phase() == PoseSequence::Phase::Done;
}

void VisitJob::interrupt() {
    if (!isOver())
        m_failure = VisitFailure{};
}

void VisitJob::fail(VisitFailure::Reason reason, const Snapshot& snapshot, std::optional<Event> event) {
    m_failure = VisitFailure{reason, std::move(event), snapshot.state, snapshot.status};
}

/// Until the first pose is asked for.
void VisitJob::awaitReady(const Snapshot& snapshot) {
    for (const Event& event : snapshot.events) {
        if (event.code == EventCode::ControllerRefused)
            m_uselessAnswer = event;
        if (event.code == EventCode::LinkLost || event.code == EventCode::LoopFailed)
            return fail(VisitFailure::Reason::Ended, snapshot, event);
    }
    if (snapshot.link == LinkState::ListenOnly)
        return fail(VisitFailure::Reason::TakesNoCommands, snapshot);
    if (!m_connectedAt && snapshot.state != RunState::Disconnected)
        m_connectedAt = snapshot.time;
    if (!m_connectedAt && snapshot.time > m_options.answerWithin)
        fail(m_uselessAnswer ? VisitFailure::Reason::UselessAnswer : VisitFailure::Reason::NoAnswer, snapshot,
             m_uselessAnswer);
    else if (m_connectedAt && snapshot.time - *m_connectedAt > m_options.readyWithin)
        fail(VisitFailure::Reason::NotReady, snapshot);
}

std::vector<OperatorCommand> VisitJob::add(const Snapshot& snapshot) {
    if (isOver()) {
        for (const Event& event : snapshot.events)
            if (isFault(event.code) || event.code == EventCode::DisableUnconfirmed)
                m_closingFaults.push_back(event);
        return {};
    }
    std::vector<OperatorCommand> commands;
    if (!std::exchange(m_speedPosted, true))
        commands.push_back(SpeedCommand{m_options.speedOverride});
    if (std::optional<SettledSample> sample = m_sampler.add(snapshot))
        m_samples.push_back(*sample);
    const bool waiting = m_sequence.phase() == PoseSequence::Phase::Waiting;
    if (waiting)
        awaitReady(snapshot);
    if (m_failure)
        return {};
    if (waiting && m_options.clearFirst && isDown(snapshot.state)) {
        if (!std::exchange(m_clearPosted, true))
            commands.push_back(ClearCommand{});
        return commands;
    }
    if (const std::optional<Pose> next = m_sequence.add(snapshot)) {
        if (m_options.sweep)
            commands.push_back(SweepCommand{*m_options.sweep, m_sequence.id()});
        else
            commands.push_back(RunCommand{*next, m_options.mode, m_sequence.id()});
    }
    if (m_sequence.phase() == PoseSequence::Phase::Failed)
        fail(VisitFailure::Reason::Ended, snapshot, m_sequence.failure());
    return commands;
}

void advance(VisitJob& job, SnapshotReader& reader, Session& session) {
    for (const SnapshotPtr& snapshot : reader.take())
        for (const OperatorCommand& command : job.add(*snapshot))
            session.post(command);
}

void runToTheEnd(VisitJob& job, Session& session, const std::function<bool()>& interrupted) {
    SnapshotReader reader = session.reader();
    while (!job.isOver()) {
        if (interrupted())
            job.interrupt();
        reader.wait(kLookEvery);
        advance(job, reader, session);
    }
    session.close();
    advance(job, reader, session); // the closing may have something to report
}

} // namespace hexapose
