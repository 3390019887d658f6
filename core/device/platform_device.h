// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/device_notice.h"
#include "core/geometry/leg_lengths.h"
#include "core/record/controller_state.h"
#include "core/record/device_refusal.h"
#include "core/record/link_state.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hexapose {

/// What goes out in a cycle. Nothing is sent for an empty set-point.
struct SetPoints {
    std::optional<LegLengths> lengths; ///< m
    /// Of the loop's requests (None to Clear) one a cycle; Stop beats everything else in the same cycle.
    DeviceRequest request = DeviceRequest::None;
};

/// What came back. A device sets `lengths` and `receivedAt` together, only when a new measurement arrived
/// with this read, and empties `notices` at the beginning of each.
struct DeviceFeedback {
    std::optional<LegLengths> lengths; ///< measured, m
    /// Of the last measurement ever. Where it is not set the loop takes every measurement for stale, and
    /// nothing moves.
    std::chrono::steady_clock::time_point receivedAt{};
    /// The controller's clock at that measurement; empty where it has none.
    std::optional<std::chrono::microseconds> controllerTime;
    /// From the sending of a set-point to the measurement of this read, the first that confirms it; the wait
    /// for that measurement included.
    std::optional<std::chrono::nanoseconds> roundTrip;
    LinkState link = LinkState::Connecting;
    ControllerState state = ControllerState::Unknown; ///< as of the last measurement
    bool protectedLink = false;                       ///< lengths came in checked frames
    std::optional<std::int32_t> acceptedSetPoint;     ///< number of the last set-point that was accepted
    bool echoesSetPoints = false;        ///< acceptedSetPoint is reported; without a value then: none yet
    std::chrono::milliseconds period{0}; ///< feedback period in force; 0: not known
    std::optional<double> minLength;     ///< the controller's own limits, m, once known
    std::optional<double> maxLength;
    std::string controllerName;
    LinkCounters counters;
    std::vector<DeviceNotice> notices; ///< since the last read; what stays here is reported again
};

/// A platform's controller. One thread owns it and calls read() and write() in turn; neither throws for what
/// a controller sends, and a lost port is LinkState::Lost.
class PlatformDevice {
public:
    virtual ~PlatformDevice() = default;
    /// Waits for the next measurement, but no longer than about 15 ms, so that what was asked for meanwhile
    /// goes out soon. The feedback is the device's own until the next read.
    virtual const DeviceFeedback& read() = 0;
    virtual void write(const SetPoints& setPoints) = 0;
    /// From any thread: the read that waits, or the next one, returns at once, without a measurement where
    /// none came.
    virtual void interrupt() = 0;
};

} // namespace hexapose
