// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/device_refusal.h"

#include <string_view>

/// The words of the line protocol in answers. Those of the log are its own (core/record/device_words.h), even
/// where they are the same today.
namespace hexapose::line {

/// The request that a message type means; Other for a type that is none of ours.
DeviceRequest requestOfType(std::string_view type);
/// Why a controller refused; Other for a code that the protocol does not have.
RefusalReason reasonOfCode(std::string_view code);

} // namespace hexapose::line
