// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/pose.h"

#include <cstdint>

namespace hexapose {

/// Random poses, uniform in a box about home. Stream i of a seed is independent of stream j, and the same on
/// every machine (SplitMix64; no std distribution, which differs between libraries).
class PoseSamples {
public:
    /// offsetRange: +- m; angleRange: +- rad.
    PoseSamples(double offsetRange, double angleRange, std::uint64_t seed, std::uint64_t stream) noexcept
        : m_offsetRange(offsetRange), m_angleRange(angleRange),
          m_state(scramble(seed) ^ scramble(~stream * kStep)) {}

    Pose next() noexcept {
        const auto draw = [this](double range) { return range * uniform(); };
        Pose pose; // one draw a statement: the order is part of the result
        for (int k = 0; k < 3; ++k)
            pose.offset[k] = draw(m_offsetRange);
        pose.angles.alpha = draw(m_angleRange);
        pose.angles.beta = draw(m_angleRange);
        pose.angles.gamma = draw(m_angleRange);
        return pose;
    }

private:
    static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ULL;
    static constexpr std::uint64_t scramble(std::uint64_t z) noexcept {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    /// In [-1, 1), from 53 bits.
    double uniform() noexcept {
        m_state += kStep;
        return static_cast<double>(scramble(m_state) >> 11) * 0x1p-52 - 1.0;
    }

    double m_offsetRange, m_angleRange;
    std::uint64_t m_state;
};

} // namespace hexapose
