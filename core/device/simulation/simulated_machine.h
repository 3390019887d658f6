// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"
#include "core/device/simulation/virtual_platform.h"
#include "core/geometry/platform_geometry.h"

#include <chrono>
#include <functional>
#include <memory>

namespace hexapose {

/// A virtual platform and its host's device in one piece, with a clock that only the device moves: every byte
/// of the line protocol is passed, and an hour takes a second. The same on every run.
class SimulatedMachine {
public:
    explicit SimulatedMachine(const PlatformGeometry& geometry, const VirtualPlatformOptions& options = {},
                              std::chrono::milliseconds period = std::chrono::milliseconds(10));
    ~SimulatedMachine();

    PlatformDevice& device();
    std::function<std::chrono::steady_clock::time_point()> clock() const;
    LegLengths trueLengths() const; ///< m, neither rounded nor late
    /// A leg yields under a load: it ends so far beside its set-point, as slowly as it follows one. m; 0
    /// takes the load away. Legs are counted from 0.
    void push(int leg, double offset);

private:
    struct Impl;
    std::shared_ptr<Impl> m_impl;
};

} // namespace hexapose
