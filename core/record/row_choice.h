// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/snapshot.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hexapose {

/// Which cycles become rows of the log. While something happens: every fresh measurement, every event, every
/// change of state, and one row in 100 ms otherwise. At rest, when nothing has moved or changed for longer
/// than a second: ten rows a second. The measurements since the last of those are kept back, and come before
/// the first row in which something happens.
class RowChoice {
public:
    using SnapshotPtr = std::shared_ptr<const Snapshot>;

    RowChoice();
    /// The rows that are due with this cycle, the oldest first; they stand until the next call.
    std::span<const SnapshotPtr> add(const SnapshotPtr& snapshot);
    /// Whether nothing happened for so long that rows are few.
    bool isAtRest() const { return m_isAtRest; }

private:
    /// What a cycle has apart from its measurement.
    struct Setting {
        RunState state;
        LinkState link;
        ControllerState controllerState;
        bool stale, held;
        MotionMode mode;
        MotionId motionId;
        double speed;
        std::optional<LegLengths> setPoints;
        bool operator==(const Setting&) const = default;
    };
    static Setting settingOf(const Snapshot& snapshot);
    bool happens(const Snapshot& snapshot);
    bool isDue(const Snapshot& snapshot) const;

    std::optional<Setting> m_setting;    ///< of the last cycle
    std::optional<RunState> m_state;     ///< of the last row
    std::optional<SolveStatus> m_status; ///< of the last measurement
    std::optional<LegLengths> m_lengths; ///< when something happened last
    std::chrono::nanoseconds m_happened{0};
    std::chrono::nanoseconds m_lastRow{0};
    bool m_isAtRest = false;
    std::vector<SnapshotPtr> m_keptBack; ///< memory is taken once
    std::vector<SnapshotPtr> m_due;
};

} // namespace hexapose
