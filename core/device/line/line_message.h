// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"
#include "core/geometry/leg_lengths.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

/// Payloads of the line protocol, version 1, as values. Lengths are metres here and millimetres on the wire.
namespace hexapose::line {

inline constexpr std::size_t kMaxPayload = 240; ///< bytes between '$' and '*'
inline constexpr int kMinPeriodMs = 1;
inline constexpr int kMaxPeriodMs = 1000;

// Host to controller.
struct Hello {};
struct Period {
    std::chrono::milliseconds period{0};
};
struct Home {};
struct Enable {};
struct Disable {};
struct Set {
    std::uint16_t number = 0;
    LegLengths lengths = LegLengths::Zero();
};
struct Stop {};
struct Clear {};

// Controller to host.
struct Ident {
    std::string name;
    std::chrono::milliseconds period{0};
    double minLength = 0.0;
    double maxLength = 0.0;
};
/// An IDENT of a protocol version or leg count that nothing here speaks.
struct UnsupportedIdent {
    RefusalReason reason = RefusalReason::ProtocolVersion; ///< LegCount or IdentityFields
    long long number = 0;                                  ///< what it sent instead
};
struct Len {
    std::uint16_t number = 0;
    std::chrono::microseconds time{0}; ///< the controller's clock
    LegLengths lengths = LegLengths::Zero();
    ControllerState state = ControllerState::Unknown;
    std::int32_t setNumber = -1; ///< last accepted SET; -1 before the first
};
struct Ok {
    std::string request;
};
struct Err {
    std::string request;
    std::string code;
    std::string text;
};
struct Fault {
    std::string code;
    std::string text;
};

/// A bare line of six lengths, with no check around it.
struct PlainLengths {
    LegLengths lengths = LegLengths::Zero();
};

/// Arrived whole, but is not of the protocol: nothing of it may be used.
struct Malformed {
    enum class Cause { UnknownType, Fields, Number, Range };
    Cause cause = Cause::Fields;
    std::string type; ///< first field, for the answer
};

using LineMessage = std::variant<Hello, Period, Home, Enable, Disable, Set, Stop, Clear, Ident,
                                 UnsupportedIdent, Len, Ok, Err, Fault, PlainLengths, Malformed>;

/// Who reads: a host knows the messages of controllers, and the reverse.
enum class Side { Host, Controller };

/// A payload whose checksum was right.
LineMessage parsePayload(std::string_view payload, Side reader);

/// Six decimals separated by a comma, semicolon, tab or blanks: PlainLengths, or Malformed for any other
/// line.
LineMessage parsePlainLine(std::string_view line);

/// The payload of a message; "" for those that never travel (UnsupportedIdent, PlainLengths, Malformed).
std::string payloadOf(const LineMessage& message);

} // namespace hexapose::line
