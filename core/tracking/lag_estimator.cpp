// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/tracking/lag_estimator.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kMemory = 4.0;       ///< s of motion after which a measurement counts a third
constexpr double kSlowest = 1e-3;     ///< m/s: below it a leg stands, of which the rounding makes no rate
constexpr double kGuessWeight = 1e-6; ///< (m/s)^2 s: of motion that the guess of the lag is worth
constexpr double kOffsetWeight = 1.0; ///< s of measurements that the guess of no offset is worth

} // namespace

void LegLagEstimator::interrupt() {
    m_count = 0;
}

void LegLagEstimator::add(const LegLengths& setPoint, const LegLengths& measured, double seconds) {
    if (m_count == 0)
        m_last = {LegLengths::Zero(), measured, 0.0};
    const LegLengths gap = setPoint - 0.5 * (measured + m_last.measured);
    m_last = {m_last.gapSum + seconds * gap, measured, m_last.time + seconds};
    if (m_count == kWindow) {
        const Sample& first = m_ring[static_cast<std::size_t>(m_next)];
        const double span = m_last.time - first.time;
        for (int leg = 0; leg < kLegCount && span > 0.0; ++leg) {
            const double rate = (m_last.measured[leg] - first.measured[leg]) / span;
            const double meanGap = (m_last.gapSum[leg] - first.gapSum[leg]) / span;
            if (std::abs(rate) < kSlowest)
                continue;
            Sums& s = m_sums[static_cast<std::size_t>(leg)];
            const double keep = std::exp(-seconds / kMemory);
            s = {keep * s.n + seconds, keep * s.x + seconds * rate, keep * s.y + seconds * meanGap,
                 keep * s.xx + seconds * rate * rate, keep * s.xy + seconds * rate * meanGap};
            // Least squares for lag and offset, with a guess for both: at one even rate they look alike.
            const double xx = s.xx + kGuessWeight;
            const double xy = s.xy + kGuessWeight * guess();
            const double n = s.n + kOffsetWeight;
            m_lags[leg] = std::clamp((xy * n - s.x * s.y) / (xx * n - s.x * s.x), 0.0, longest());
        }
    }
    m_ring[static_cast<std::size_t>(m_next)] = m_last;
    m_next = (m_next + 1) % kWindow;
    m_count = std::min(m_count + 1, kWindow);
}

} // namespace hexapose
