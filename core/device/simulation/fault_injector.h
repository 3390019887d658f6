// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace hexapose {

/// What goes wrong on a simulated line. Probabilities are per frame.
struct FaultSpec {
    double crc = 0.0;                         ///< wrong checksum
    double drop = 0.0;                        ///< frame lost
    double garbage = 0.0;                     ///< random bytes before a frame
    double nan = 0.0;                         ///< a length that reads "nan", under a right checksum
    double torn = 0.0;                        ///< rest of a frame lost
    double noise = 0.0;                       ///< m, standard deviation of the measured lengths
    std::chrono::nanoseconds silence{0};      ///< nothing is sent for so long,
    std::chrono::nanoseconds silenceAfter{0}; ///< so long after the start
    std::uint64_t seed = 1;
};

/// "crc=0.01,drop=0.02,garbage=0.01,nan=0.01,torn=0.02,silence=10@5,noise=0.05,seed=7": silence in seconds
/// after seconds, noise in mm. Throws InputError that names the piece.
FaultSpec parseFaultSpec(std::string_view spec);

/// Corrupts outgoing frames, identically each time for a seed.
class FaultInjector {
public:
    explicit FaultInjector(const FaultSpec& spec) : m_spec(spec), m_random(spec.seed) {}
    /// The bytes that leave instead of the frame, now = time since the start.
    std::string apply(const std::string& frame, std::chrono::nanoseconds now);

private:
    bool happens(double probability);
    std::size_t below(std::size_t bound);

    FaultSpec m_spec;
    std::mt19937_64 m_random;
};

} // namespace hexapose
