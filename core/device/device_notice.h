// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/device_refusal.h"
#include "core/record/port_failure.h"

#include <string>
#include <variant>

namespace hexapose {

/// Something that happened on the wire.
namespace notice {
/// The controller has identified itself.
struct Identified {
    std::string name;
};
/// A request was refused, by the controller or on its behalf.
struct Refused {
    DeviceRefusal refusal;
};
/// The controller reports a fault.
struct Fault {
    std::string text; ///< its code and words
};
/// A request was accepted: Reference, which may last minutes, or Clear.
struct Acknowledged {
    DeviceRequest request;
};
/// A request was not answered in time.
struct NoAnswer {
    DeviceRequest request;
};
/// The controller's clock went back: it restarted, or a stray frame came.
struct ClockWentBack {};
/// Plain lines of lengths arrive: an unprotected sender.
struct ListenOnly {};
struct LinkLost {
    PortFailure failure;
};
} // namespace notice

using DeviceNotice =
    std::variant<notice::Identified, notice::Refused, notice::Fault, notice::Acknowledged, notice::NoAnswer,
                 notice::ClockWentBack, notice::ListenOnly, notice::LinkLost>;

} // namespace hexapose
