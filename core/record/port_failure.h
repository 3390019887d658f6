// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hexapose {

/// Why a port cannot be opened, or was lost.
struct PortFailure {
    enum class Kind {
        NotFound,     ///< no such port
        NotAPort,     ///< the path is not that of a serial port
        NoPermission, ///< the user may not open it
        Busy,         ///< another program has it open
        NotOpened,    ///< the system did not open it
        Gone,         ///< it was unplugged, or closed at the other end
        NotTaking,    ///< it accepts no more bytes
        Closed,       ///< it was closed after an earlier failure
        Other,        ///< see system
    };
    Kind kind = Kind::Other;
    std::string path = {};
    std::string system = {}; ///< the system's own words, where there are any
    bool operator==(const PortFailure&) const = default;
};

} // namespace hexapose
