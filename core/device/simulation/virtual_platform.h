// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"
#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <random>
#include <string>

namespace hexapose {

struct VirtualPlatformOptions {
    std::array<double, kLegCount> timeConstants{0.050, 0.070, 0.090, 0.110, 0.130, 0.150}; ///< s
    double speedLimit = 0.100;                                                             ///< m/s, each leg
    double resolution = 1e-4; ///< m, of the measured lengths
    double noise = 0.0;       ///< m, standard deviation before rounding
    std::uint64_t seed = 1;
    std::chrono::milliseconds watchdog{250};
};

/// Six simulated servo legs and the drives' states; no clock and no bytes of its own. Starts unreferenced,
/// with the legs at their home lengths.
class VirtualPlatform {
public:
    /// Why a command was refused.
    enum class Refusal { None, State, Range };

    explicit VirtualPlatform(const PlatformGeometry& geometry, const VirtualPlatformOptions& options = {});

    void step(std::chrono::nanoseconds duration);
    /// A valid frame came: the watchdog starts over.
    void feedWatchdog() { m_unheard = std::chrono::nanoseconds(0); }

    Refusal reference();
    Refusal enable();
    Refusal disable();
    Refusal set(const LegLengths& lengths);
    void stop();
    void clear();
    void fail();

    ControllerState state() const { return m_state; }
    LegLengths lengths() const { return m_lengths; } ///< true ones
    /// A load on a leg (0..5): its servo ends so far beside its set-point, m. 0 takes it away.
    void push(int leg, double offset) { m_loads[leg] = offset; }
    LegLengths measure();          ///< with noise and resolution
    double shortestStroke() const; ///< the envelope of all legs: no leg goes below
    double longestStroke() const;

private:
    void move(double seconds);
    void hold() { m_targets = m_lengths; }

    VirtualPlatformOptions m_options;
    LegLengths m_home;
    LegLengths m_min;
    LegLengths m_max;
    LegLengths m_lengths;
    LegLengths m_targets;
    LegLengths m_loads = LegLengths::Zero();
    ControllerState m_state = ControllerState::Unreferenced;
    bool m_referenced = false;
    bool m_referencing = false;
    std::chrono::nanoseconds m_unheard{0};
    std::mt19937_64 m_random;
    std::normal_distribution<double> m_gauss;
};

} // namespace hexapose
