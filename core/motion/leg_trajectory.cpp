// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/leg_trajectory.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

/// Peak of ds/dtau of the minimum-jerk profile s = 10 tau^3 - 15 tau^4 + 6 tau^5, at tau = 1/2.
constexpr double kPeakRate = 1.875;
/// A move is never quicker than this, so that tiny moves are smooth for the drives too.
constexpr std::chrono::duration<double> kShortest{0.2};

} // namespace

LegTrajectory::LegTrajectory(const LegLengths& from, const LegLengths& to, double legSpeed)
    : m_from(from), m_to(to), m_duration(0) {
    const double longest = (to - from).cwiseAbs().maxCoeff();
    const std::chrono::duration<double> duration(kPeakRate * longest / legSpeed);
    m_duration = std::chrono::duration_cast<std::chrono::nanoseconds>(std::max(duration, kShortest));
}

double LegTrajectory::fractionAt(std::chrono::nanoseconds elapsed) const {
    const double tau = std::clamp(
        std::chrono::duration<double>(elapsed) / std::chrono::duration<double>(m_duration), 0.0, 1.0);
    return tau * tau * tau * (10.0 + tau * (-15.0 + 6.0 * tau));
}

LegLengths LegTrajectory::at(std::chrono::nanoseconds elapsed) const {
    if (elapsed >= m_duration)
        return m_to; // exactly, not to rounding
    return m_from + fractionAt(elapsed) * (m_to - m_from);
}

} // namespace hexapose
