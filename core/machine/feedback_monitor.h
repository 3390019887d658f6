// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"

#include <chrono>
#include <deque>
#include <optional>

namespace hexapose {

/// Age, staleness and rate of the measurements.
class FeedbackMonitor {
public:
    using Clock = std::chrono::steady_clock;
    explicit FeedbackMonitor(std::chrono::milliseconds staleAfter) : m_staleAfter(staleAfter) {}

    void update(const DeviceFeedback& feedback, Clock::time_point now);
    bool everMeasured() const { return m_ever; }
    /// Old data is unknown data: also true before the first measurement.
    bool stale() const { return m_stale; }
    std::chrono::nanoseconds age() const { return m_age; }
    double rateHz() const;
    /// How much later than the feedback period after the one before the measurement of this update came;
    /// empty without one, after a gap in the connection, and while the period is not known.
    std::optional<std::chrono::nanoseconds> jitter() const { return m_jitter; }
    /// The port was closed or lost: what was measured before counts no more.
    void forget();

private:
    std::chrono::milliseconds m_staleAfter;
    std::deque<Clock::time_point> m_recent; ///< of the last second
    Clock::time_point m_last{};
    std::chrono::nanoseconds m_age{0};
    std::optional<std::chrono::nanoseconds> m_jitter;
    bool m_continues = false; ///< nothing has happened to the connection since the last measurement
    bool m_ever = false;
    bool m_stale = true;
};

} // namespace hexapose
