// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/pose.h"
#include "core/record/snapshot.h"

#include <chrono>
#include <optional>

namespace hexapose {

/// One settled pose: where the platform was sent, and the lengths it reported, averaged.
struct SettledSample {
    Pose target;
    LegLengths meanLengths = LegLengths::Zero(); ///< m
    int measurements = 0;                        ///< averaged
    std::chrono::nanoseconds start{0};           ///< session time of the first
};

/// Finds settled poses in a stream of snapshots, live or read from a log: after a move (state moving or
/// settling) the first `window` of fresh measurements in state enabled with the same goal are averaged. When
/// the platform is sent on, or leaves that state, before the window is over, half of it is enough.
class SettledSampler {
public:
    explicit SettledSampler(std::chrono::nanoseconds window = std::chrono::seconds(1)) : m_window(window) {}
    /// A sample when this snapshot completes one.
    std::optional<SettledSample> add(const Snapshot& snapshot);
    /// At the end of a log: a sample that was begun and has at least half of the window.
    std::optional<SettledSample> finish();

private:
    SettledSample close();

    std::chrono::nanoseconds m_window;
    bool m_moved = false;
    std::optional<SettledSample> m_open;
    LegLengths m_sum = LegLengths::Zero();
    std::chrono::nanoseconds m_last{0};
};

} // namespace hexapose
