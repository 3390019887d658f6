// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/pose.h"

#include <cstdint>

namespace hexapose {

/// Seeded poses, uniform in a box about home. The same on every platform and library: SplitMix64 and 53
/// random bits a number, not the standard library's distributions.
class RandomPoses {
public:
    /// offsetRange: +- m; angleRange: +- rad. `stream` gives independent sequences of one seed.
    RandomPoses(double offsetRange, double angleRange, std::uint64_t seed, std::uint64_t stream = 0)
        : m_offsetRange(offsetRange), m_angleRange(angleRange), m_state(seed) {
        m_state = next() ^ (stream * 0xd1342543de82ef95ULL);
        next();
    }

    Pose operator()() {
        PoseVector v;
        for (int k = 0; k < 6; ++k)
            v[k] = (k < 3 ? m_offsetRange : m_angleRange) * symmetric();
        return Pose::fromVector(v);
    }

private:
    std::uint64_t next() {
        m_state += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    double symmetric() { return static_cast<double>(next() >> 11) * 0x1.0p-52 - 1.0; }

    double m_offsetRange;
    double m_angleRange;
    std::uint64_t m_state;
};

} // namespace hexapose
