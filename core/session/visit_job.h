// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/machine/command.h"
#include "core/record/snapshot.h"
#include "core/report/settled_sample.h"
#include "core/session/pose_sequence.h"
#include "core/session/session.h"

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

namespace hexapose {

/// Why a job ended before all poses were visited.
struct VisitFailure {
    enum class Reason {
        NoAnswer,        ///< no controller within the time allowed
        UselessAnswer,   ///< event: what came in place of an answer
        TakesNoCommands, ///< an unprotected sender of lengths
        NotReady,        ///< connected, but no pose to begin from: status, state
        Ended,           ///< event: what ended it, in this state
        Interrupted,
    };
    Reason reason = Reason::Interrupted;
    std::optional<Event> event;
    RunState state = RunState::Disconnected;
    SolveStatus status = SolveStatus::InvalidInput; ///< of the last measurement's solution
};

/// The operator's main job without an operator: connect, reference, enable, visit a list of poses, take a
/// sample of each. Fed with every snapshot of a session; it returns what to post. Pure, so that the command
/// line and the console share it.
class VisitJob {
public:
    struct Options {
        MotionMode mode = MotionMode::Joint;
        double speedOverride = 1.0;            ///< 0..1
        std::optional<SweepSettings> sweep;    ///< in place of the first pose
        bool clearFirst = false;               ///< clear a stop or fault that the controller is in
        std::chrono::seconds answerWithin{10}; ///< a controller, from the session's start
        std::chrono::seconds readyWithin{10};  ///< a pose to begin from, from the connection on
    };

    VisitJob(std::vector<Pose> targets, const Options& options);

    /// What to post now. Once the job is over nothing more is asked for, and what still goes wrong is kept.
    std::vector<OperatorCommand> add(const Snapshot& snapshot);
    void interrupt();
    bool isOver() const;

    const Options& options() const { return m_options; }
    const std::vector<SettledSample>& samples() const { return m_samples; }
    std::size_t visited() const { return m_sequence.finished(); }
    std::size_t count() const { return m_sequence.count(); }
    /// Nothing when all poses were visited.
    const std::optional<VisitFailure>& failure() const { return m_failure; }
    /// What went wrong after the end: the drives may still be on.
    const std::vector<Event>& closingFaults() const { return m_closingFaults; }

private:
    void awaitReady(const Snapshot& snapshot);
    void fail(VisitFailure::Reason reason, const Snapshot& snapshot, std::optional<Event> event = {});

    Options m_options;
    PoseSequence m_sequence;
    SettledSampler m_sampler;
    std::vector<SettledSample> m_samples;
    std::optional<VisitFailure> m_failure;
    std::vector<Event> m_closingFaults;
    std::optional<Event> m_uselessAnswer;
    std::optional<std::chrono::nanoseconds> m_connectedAt;
    bool m_speedPosted = false;
    bool m_clearPosted = false;
};

/// Hands the job all that the reader has, and the session all that the job asks for.
void advance(VisitJob& job, SnapshotReader& reader, Session& session);

/// From an open session to a closed one: until the job is over or `interrupted` returns true; then the
/// platform is stopped and disabled, whatever the reason.
void runToTheEnd(VisitJob& job, Session& session, const std::function<bool()>& interrupted);

} // namespace hexapose
