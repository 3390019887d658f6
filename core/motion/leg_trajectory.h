// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"

#include <chrono>

namespace hexapose {

/// Straight in leg lengths, all legs together, minimum-jerk in time (quintic: speed and acceleration zero at
/// both ends), as fast as the leg speed allows.
class LegTrajectory {
public:
    /// lengths in m, legSpeed in m/s (the largest speed any leg reaches).
    LegTrajectory(const LegLengths& from, const LegLengths& to, double legSpeed);
    /// Set-points at a time since the start; before it `from`, after the end `to`.
    LegLengths at(std::chrono::nanoseconds elapsed) const;
    /// Part of the path, 0..1.
    double fractionAt(std::chrono::nanoseconds elapsed) const;
    std::chrono::nanoseconds duration() const { return m_duration; }

private:
    LegLengths m_from;
    LegLengths m_to;
    std::chrono::nanoseconds m_duration;
};

} // namespace hexapose
