// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/event_codec.h"

#include <string_view>

namespace hexapose {

/// An event from its words in the log.
inline Event eventFrom(std::string_view words) {
    return parseEvent(words).value();
}

} // namespace hexapose
