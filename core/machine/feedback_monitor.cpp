// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/feedback_monitor.h"

#include <algorithm>

namespace hexapose {

namespace {
constexpr std::chrono::seconds kRateWindow{1};
} // namespace

void FeedbackMonitor::update(const DeviceFeedback& feedback, Clock::time_point now) {
    m_jitter.reset();
    if (feedback.lengths) {
        if (m_continues && feedback.period > std::chrono::milliseconds(0))
            m_jitter = feedback.receivedAt - m_last - feedback.period;
        m_ever = m_continues = true;
        m_last = feedback.receivedAt;
        m_recent.push_back(feedback.receivedAt);
    }
    while (!m_recent.empty() && now - m_recent.front() > kRateWindow)
        m_recent.pop_front();
    if (!m_ever)
        return;
    m_age = std::max(std::chrono::nanoseconds(now - m_last), std::chrono::nanoseconds(0));
    m_stale = m_age > std::max<std::chrono::nanoseconds>(m_staleAfter, 3 * feedback.period);
}

double FeedbackMonitor::rateHz() const {
    if (m_recent.size() < 2 || m_stale)
        return 0.0;
    const std::chrono::duration<double> span = m_recent.back() - m_recent.front();
    return span.count() > 0.0 ? static_cast<double>(m_recent.size() - 1) / span.count() : 0.0;
}

void FeedbackMonitor::forget() {
    m_recent.clear();
    m_stale = true;
    m_continues = false;
}

} // namespace hexapose
