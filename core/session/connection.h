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

/// Where to connect. A new kind of link is a new alternative here and in the program's device factory.
using ConnectionSpec = std::variant<VirtualConnection, SerialConnection>;

/// What the log calls it: "virtual", or the path of the port.
inline std::string nameOf(const VirtualConnection&) {
    return "virtual";
}
inline std::string nameOf(const SerialConnection& connection) {
    return connection.path;
}
inline std::string nameOf(const ConnectionSpec& connection) {
    return std::visit([](const auto& kind) { return nameOf(kind); }, connection);
}

} // namespace hexapose
