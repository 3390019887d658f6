// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <variant>

namespace hexapose {

/// The virtual platform that is built in.
struct VirtualConnection {
    bool operator==(const VirtualConnection&) const = default;
};

/// A controller on a serial port.
struct SerialConnection {
    static constexpr int kUsualBaud = 115200;
    std::string path;
    int baud = kUsualBaud;
    bool operator==(const SerialConnection&) const = default;
};

/// Where to connect. A new kind of link is a new alternative here, with its name below, and in the
/// program's device factory.
using ConnectionSpec = std::variant<VirtualConnection, SerialConnection>;

/// One function a kind of connection: a kind without one does not compile.
struct ConnectionName {
    std::string operator()(const VirtualConnection&) const { return "virtual"; }
    std::string operator()(const SerialConnection& serial) const { return serial.path; }
};

/// What the log calls it: "virtual", or the path of the port.
inline std::string nameOf(const ConnectionSpec& connection) {
    return std::visit(ConnectionName{}, connection);
}

} // namespace hexapose
