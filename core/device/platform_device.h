// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hexapose {

/// What the controller says of itself.
enum class ControllerState : char {
    Unknown = '?',
    Unreferenced = 'U',
    Disabled = 'D',
    Enabled = 'E',
    Stopped = 'S',
    Fault = 'F',
};

/// One request a cycle; Stop beats everything else in the same cycle.
enum class DeviceRequest { None, Reference, Enable, Disable, Stop, Clear };

/// What goes out in a cycle. Nothing is sent for an empty set-point.
struct SetPoints {
    std::optional<LegLengths> lengths; ///< m
    DeviceRequest request = DeviceRequest::None;
    /// Set from any thread while exchange() waits: it then returns within about 2 ms, without a measurement
    /// where none came. Outlives the exchange; none: nothing ends the wait early.
    const std::atomic<bool>* hurry = nullptr;
};

enum class LinkState {
    Connecting, ///< open, the controller has not yet said who it is
    Connected,  ///< a controller that takes commands
    ListenOnly, ///< an unprotected sender of lengths; takes no commands
    Lost,       ///< the port is gone
};

/// Something that happened on the wire since the last exchange.
struct DeviceNotice {
    enum class Kind {
        Identified,    ///< text: name
        Refused,       ///< ERR: request = type field, text = "CODE text"
        Fault,         ///< FAULT: request = code, text
        Acknowledged,  ///< request = HOME: it was taken, and may last minutes
        NoAnswer,      ///< request = type that was not answered in time
        ClockWentBack, ///< the controller's clock went back: it restarted, or a stray frame
        ListenOnly,    ///< plain lines of lengths arrive: an unprotected sender
        LinkLost,      ///< text: what the system says
    };
    Kind kind;
    std::string request;
    std::string text;
};

/// Frames and lines counted since the connection was opened; a port that went and came back is the same one.
struct LinkCounters {
    std::uint64_t accepted = 0;      ///< good frames of every type, and listen-only lines
    std::uint64_t droppedCrc = 0;    ///< checksum wrong
    std::uint64_t droppedLength = 0; ///< payload over 240 bytes, or a frame torn by the next '$'
    std::uint64_t droppedFields = 0; ///< unknown type or wrong number of fields
    std::uint64_t droppedNumber = 0; ///< a number that is not of the protocol's form or range, NaN among them
    std::uint64_t droppedGarbage = 0; ///< lines or runs of bytes outside a frame
    std::uint64_t droppedOrder = 0;   ///< repeated frame, or a controller clock that went back
    std::uint64_t missed = 0;         ///< frames the controller counted and we never saw
    std::uint64_t dropped() const {
        return droppedCrc + droppedLength + droppedFields + droppedNumber + droppedGarbage + droppedOrder;
    }
    LinkCounters& operator+=(const LinkCounters& other) {
        accepted += other.accepted;
        droppedCrc += other.droppedCrc;
        droppedLength += other.droppedLength;
        droppedFields += other.droppedFields;
        droppedNumber += other.droppedNumber;
        droppedGarbage += other.droppedGarbage;
        droppedOrder += other.droppedOrder;
        missed += other.missed;
        return *this;
    }
};

/// What came back. lengths is set only when a new measurement arrived in this exchange.
struct DeviceFeedback {
    std::optional<LegLengths> lengths;                  ///< measured, m
    std::chrono::steady_clock::time_point receivedAt{}; ///< of the last measurement ever
    std::chrono::microseconds controllerTime{0};        ///< the controller's clock at that measurement
    LinkState link = LinkState::Connecting;
    ControllerState state = ControllerState::Unknown; ///< as of the last measurement
    bool protectedLink = false;                       ///< lengths came in checked frames
    std::optional<std::int32_t> acceptedSetPoint;     ///< number of the last set-point that was accepted
    bool echoesSetPoints = false;        ///< acceptedSetPoint is told; none of it then means: not one yet
    std::chrono::milliseconds period{0}; ///< feedback period in force; 0: not known
    std::optional<double> minLength;     ///< the controller's own limits, m, once known
    std::optional<double> maxLength;
    std::string controllerName;
    LinkCounters counters;
    std::vector<DeviceNotice> notices; ///< empty in an ordinary cycle
};

/// A platform's controller. One thread owns it.
class PlatformDevice {
public:
    virtual ~PlatformDevice() = default;
    /// Sends, then waits for the next measurement, but never longer than about 15 ms, so that what was
    /// asked for meanwhile goes out soon; `hurry` ends the wait. Never throws for what a controller sends; a
    /// lost port is LinkState::Lost.
    virtual DeviceFeedback exchange(const SetPoints& setPoints) = 0;
};

} // namespace hexapose
