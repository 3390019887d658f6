// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/following_error_monitor.h"

#include <algorithm>

namespace hexapose {

namespace {

/// A host that stood still has sent little: time alone accuses no controller.
constexpr int kFewestUnechoed = 10;

} // namespace

void FollowingErrorMonitor::sent(Clock::time_point now) {
    if (!m_unechoedSince) {
        m_unechoedSince = now;
        m_unechoed = 0;
    }
    ++m_unechoed;
}

std::optional<Event> FollowingErrorMonitor::checkPath(const LegLengths& reference, const LegLengths& measured,
                                                      bool stalls) const {
    int leg = 0;
    const double gap = (reference - measured).cwiseAbs().maxCoeff(&leg);
    if (gap <= m_largestGap && !stalls)
        return std::nullopt;
    const auto cause = stalls ? FollowingError::Cause::Stalled : FollowingError::Cause::Path;
    return Event{EventCode::StoppedOnFollowingError, FollowingError{cause, leg + 1, gap, m_largestGap}};
}

std::optional<Event> FollowingErrorMonitor::checkLegs(const DeviceFeedback& feedback,
                                                      const LegLengths& setPoint, Clock::time_point now) {
    if (!feedback.lengths)
        return std::nullopt;
    int leg = 0;
    const double gap = (setPoint - *feedback.lengths).cwiseAbs().maxCoeff(&leg);
    if (!(gap <= m_largestGap))
        return Event{EventCode::StoppedOnFollowingError,
                     FollowingError{FollowingError::Cause::SetPoint, leg + 1, gap, m_largestGap}};
    if (!feedback.echoesSetPoints)
        return std::nullopt;
    if (feedback.acceptedSetPoint != m_echo) {
        m_echo = feedback.acceptedSetPoint;
        m_unechoedSince.reset();
        return std::nullopt;
    }
    if (!m_unechoedSince || m_unechoed < kFewestUnechoed)
        return std::nullopt;
    const std::chrono::nanoseconds waited = now - *m_unechoedSince;
    if (waited <= std::max<std::chrono::nanoseconds>(m_echoWithin, 3 * feedback.period))
        return std::nullopt;
    const auto ms = std::chrono::round<std::chrono::milliseconds>(waited);
    return Event{EventCode::StoppedOnNoEcho, static_cast<double>(ms.count())};
}

} // namespace hexapose
