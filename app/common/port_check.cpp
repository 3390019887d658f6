// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/common/port_check.h"

#include "core/geometry/input_error.h"

#include <sys/stat.h>

namespace hexapose {

void requireSerialPort(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0)
        throw InputError(path, "no such port");
    if (!S_ISCHR(status.st_mode))
        throw InputError(path, "is not a serial port");
}

} // namespace hexapose
