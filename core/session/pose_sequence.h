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

/// Visits a list of attitudes: the next Run is due when the one before has settled and stood for `dwell`. It
/// ends early when its own Run is refused or does not come about, when the machine stops, and when another
/// motion has begun; a command of somebody else that is refused changes nothing. Fed with snapshots; pure, so
/// the console and the command line share it.
class PoseSequence {
public:
    enum class Phase { Waiting, Moving, Dwelling, Done, Failed };
    PoseSequence(std::vector<Pose> targets, std::chrono::nanoseconds dwell);
    /// The next target to run, when it is due.
    std::optional<Pose> add(const Snapshot& snapshot);
    Phase phase() const { return m_phase; }
    std::size_t finished() const { return m_finished; } ///< attitudes done
    std::size_t begun() const { return m_begun; }       ///< motions: 0 until the loop took the first Run
    std::size_t count() const { return m_targets.size(); }
    /// Why it failed: the event that ended it.
    const std::optional<Event>& failure() const { return m_failure; }

private:
    bool ends(const Event& event) const;

    std::vector<Pose> m_targets;
    std::chrono::nanoseconds m_dwell;
    Phase m_phase = Phase::Waiting;
    std::size_t m_finished = 0;
    std::size_t m_begun = 0;
    bool m_asked = false; ///< a Run of ours has not begun yet
    std::chrono::nanoseconds m_since{0};
    std::optional<Event> m_failure;
};

} // namespace hexapose
