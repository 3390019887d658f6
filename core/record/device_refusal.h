// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hexapose {

/// What is asked of a controller. The first six are the requests of the loop, one a cycle at most; the others
/// are a device's own.
enum class DeviceRequest {
    None,
    Reference,
    Enable,
    Disable,
    Stop,
    Clear,
    SetPoint,
    Period,   ///< the feedback period
    Hello,    ///< who are you
    Identity, ///< its answer, when it cannot be used
    Other,    ///< a request that is not ours
};

/// Why a request was not carried out.
enum class RefusalReason {
    State,             ///< the controller: not in its present state
    Range,             ///< the controller: a number outside its limits
    Format,            ///< the controller: it could not read the request
    Other,             ///< the controller, for a reason of its own
    NotConnected,      ///< the host: there is no controller that accepts commands
    StopUnconfirmed,   ///< the host: a stop was sent and is not confirmed
    LengthNotPositive, ///< the host: a length that cannot be sent
    ProtocolVersion,   ///< the host: the controller speaks another protocol version
    LegCount,          ///< the host: the controller has another number of legs
    IdentityFields,    ///< the host: a field of the identity cannot be read, or is out of range
};

/// A request that was refused, by the controller or on its behalf.
struct DeviceRefusal {
    DeviceRequest request = DeviceRequest::Other;
    RefusalReason reason = RefusalReason::Other;
    std::string text = {}; ///< the controller's own words, its code first; empty where the host refused
    long long number = 0;  ///< of ProtocolVersion and LegCount: what the controller sent
    bool operator==(const DeviceRefusal&) const = default;
};

} // namespace hexapose
