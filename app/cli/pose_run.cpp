// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/pose_run.h"
#include "core/record/event_codec.h"

#include <utility>

namespace hexapose {

namespace {

/// Longer than the second that a report averages, by some feedback periods.
constexpr std::chrono::milliseconds kDwell{1100};

ControlOptions controlOptions(const PoseRun::Options& options) {
    ControlOptions control;
    control.envelope = options.envelope;
    return control;
}

} // namespace

PoseRun::PoseRun(PlatformDevice& device, const PlatformGeometry& geometry, const ForwardSolver& solver,
                 LogWriter& log, std::vector<Pose> targets, const Options& options)
    : m_log(log), m_options(options), m_sequence(std::move(targets), kDwell),
      m_loop(device, geometry, solver, controlOptions(options),
             [this](const Snapshot& snapshot) { take(snapshot); }) {}

void PoseRun::run(const std::function<bool()>& interrupted) {
    m_loop.post(SpeedCommand{m_options.speed});
    while (!m_over && m_sequence.phase() != PoseSequence::Phase::Done && !interrupted())
        m_loop.cycle();
    if (!m_failure && m_sequence.phase() != PoseSequence::Phase::Done)
        m_failure = "interrupted";
    m_ended = true;
    m_loop.shutDown();
}

void PoseRun::checkConnection(const Snapshot& snapshot) {
    const std::string within = " within " + std::to_string(m_options.connectWithin.count()) + " s";
    for (const Event& event : snapshot.events)
        if (event.code == EventCode::ControllerRefused)
            m_uselessAnswer = payloadWords(event);
    if (snapshot.link == LinkState::ListenOnly)
        m_failure = "an unprotected sender of lengths takes no commands";
    else if (snapshot.time > m_options.connectWithin)
        m_failure = m_uselessAnswer.empty() ? "no controller answered" + within
                                            : "no usable answer" + within + ": " + m_uselessAnswer;
    for (const Event& event : snapshot.events)
        if (event.code == EventCode::LinkLost)
            m_failure = payloadWords(event);
}

std::string PoseRun::endingWords(const Snapshot& snapshot) const {
    const Event& end = *m_sequence.failure();
    const bool down = snapshot.state == RunState::Stopped || snapshot.state == RunState::Fault;
    return formatEvent(end) +
           (end.code == EventCode::CommandRefused && down ? "; --clear leaves it first" : "");
}

void PoseRun::take(const Snapshot& snapshot) {
    m_log.append(snapshot);
    if (m_ended) { // the closing has something to say
        for (const Event& event : snapshot.events)
            m_failure = (m_failure ? *m_failure + "; " : "") + formatEvent(event);
        return;
    }
    m_connected = m_connected || snapshot.state != RunState::Disconnected;
    if (!m_connected || snapshot.link == LinkState::ListenOnly)
        checkConnection(snapshot);
    if (std::optional<SettledSample> sample = m_sampler.add(snapshot))
        m_samples.push_back(*sample);
    const bool down = snapshot.state == RunState::Stopped || snapshot.state == RunState::Fault;
    if (m_options.clearFirst && down && m_sequence.phase() == PoseSequence::Phase::Waiting) {
        if (!std::exchange(m_clearPosted, true))
            m_loop.post(ClearCommand{});
        return;
    }
    if (const std::optional<Pose> next = m_sequence.add(snapshot)) {
        if (m_options.sweep)
            m_loop.post(SweepCommand{*m_options.sweep});
        else
            m_loop.post(RunCommand{*next, m_options.mode});
    }
    if (m_sequence.phase() == PoseSequence::Phase::Failed && !m_failure)
        m_failure = endingWords(snapshot);
    m_over = m_failure.has_value();
}

} // namespace hexapose
