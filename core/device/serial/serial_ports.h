// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace hexapose {

/// A serial port of this computer, as the system describes it.
struct SerialPortInfo {
    std::string path; ///< "/dev/ttyUSB0"
    std::string description;
    std::string manufacturer;
    std::string serialNumber; ///< distinguishes two adapters of one kind when the path changes
};

/// Those there are now, by path.
std::vector<SerialPortInfo> listSerialPorts();

} // namespace hexapose
