// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/device_refusal.h"
#include "core/record/port_failure.h"

#include <optional>
#include <string>
#include <string_view>

namespace hexapose {

/// "HOME", "ENABLE", ...: requests as the log names them; "" for None and Other.
std::string_view toWord(DeviceRequest request);
/// Other for a word that is none of them.
DeviceRequest deviceRequestFromWord(std::string_view word);

/// "SET RANGE leg 2", "CLEAR STATE the stop is not confirmed yet": the request, then why it was refused.
std::string toWords(const DeviceRefusal& refusal);
DeviceRefusal deviceRefusalFromWords(std::string_view words);

/// "/dev/ttyUSB0: the port is gone".
std::string toWords(const PortFailure& failure);
PortFailure portFailureFromWords(std::string_view words);

} // namespace hexapose
