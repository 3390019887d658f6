// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"

#include <chrono>
#include <deque>

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
    /// The port was closed or lost: what was measured before counts no more.
    void forget();

private:
    std::chrono::milliseconds m_staleAfter;
    std::deque<Clock::time_point> m_recent; ///< of the last second
    Clock::time_point m_last{};
    std::chrono::nanoseconds m_age{0};
    bool m_ever = false;
    bool m_stale = true;
};

} // namespace hexapose
