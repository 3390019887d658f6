// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"

#include <array>

namespace hexapose {

/// How long each leg lags behind its set-point: the time T in set-point - length = T * rate + offset, found
/// by least squares over the recent motion, with the wire's delay in it. Legs that stand still give no
/// information. Pure.
class LegLagEstimator {
public:
    /// The set-point that was in force, and the length measured at the end of it; seconds since the one
    /// before.
    void add(const LegLengths& setPoint, const LegLengths& measured, double seconds);
    /// s, each within [0, longest()]. Before anything is known: guess().
    const LegLengths& lags() const { return m_lags; }
    /// What was not measured in one piece is not compared: after a pause, a stop, a new start.
    void interrupt();

    static constexpr double guess() { return 0.05; }
    static constexpr double longest() { return 0.5; }

private:
    static constexpr int kWindow = 10; ///< measurements over which a rate is taken

    struct Sample {
        LegLengths gapSum;   ///< of set-point - length over time, since the start, m s
        LegLengths measured; ///< m
        double time;         ///< s
    };
    /// Sums of the least squares, forgotten slowly.
    struct Sums {
        double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    };
    std::array<Sample, kWindow> m_ring{};
    int m_count = 0;
    int m_next = 0;
    Sample m_last{LegLengths::Zero(), LegLengths::Zero(), 0.0};
    std::array<Sums, kLegCount> m_sums{};
    LegLengths m_lags = LegLengths::Constant(guess());
};

} // namespace hexapose
