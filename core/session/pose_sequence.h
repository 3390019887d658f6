// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/pose.h"
#include "core/record/snapshot.h"

#include <chrono>
#include <optional>
#include <vector>

namespace hexapose {

/// How long a visited pose is held when a sample of it is to be taken: longer than the second that a sample
/// averages, by some feedback periods.
inline constexpr std::chrono::milliseconds kSampleDwell{1200};

/// Visits a list of poses: the next Run is due when the one before has settled and stood for `dwell`. It
/// ends early when its own Run is refused or does not come about, when the machine stops, and when another
/// motion was accepted; a command of somebody else that is refused changes nothing. Fed with snapshots; pure,
/// so the console and the command line share it.
class PoseSequence {
public:
    enum class Phase { Waiting, Moving, Dwelling, Done, Failed };
    /// firstId: of the first Run; those after it count up.
    PoseSequence(std::vector<Pose> targets, std::chrono::nanoseconds dwell, MotionId firstId = 1);
    /// The next target to run, when it is due; its command has to carry id().
    std::optional<Pose> add(const Snapshot& snapshot);
    Phase phase() const { return m_phase; }
    MotionId id() const { return m_firstId + m_finished; } ///< of the present Run
    std::size_t accepted() const { return m_accepted; }    ///< Runs that the loop took
    std::size_t finished() const { return m_finished; }    ///< poses done
    std::size_t count() const { return m_targets.size(); }
    /// Why it failed: the event that ended it.
    const std::optional<Event>& failure() const { return m_failure; }

private:
    std::optional<Pose> ask(const Snapshot& snapshot);
    std::optional<Event> end(const Snapshot& snapshot);
    bool endsTheRun(const Event& event) const;

    std::vector<Pose> m_targets;
    std::chrono::nanoseconds m_dwell;
    MotionId m_firstId;
    Phase m_phase = Phase::Waiting;
    std::size_t m_finished = 0;
    std::size_t m_accepted = 0;
    std::chrono::nanoseconds m_since{0};
    std::optional<Event> m_failure;

    // Of the present Run.
    MotionId m_idBefore = kNoMotion; ///< of the motion before it
    bool m_answered = false;         ///< the loop has dealt with the command
    bool m_taken = false;            ///< and took it
    bool m_started = false;          ///< the platform moves, or has moved
};

} // namespace hexapose
