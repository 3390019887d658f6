// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/common/port_check.h"

#include "core/base/input_error.h"
#include "core/device/file_descriptor.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <system_error>
#include <unistd.h>

namespace hexapose {

namespace {

/// Device numbers of the ends of pseudo-terminals on Linux. Whoever holds the other end is told of every
/// opening and closing, so these are not opened only to look.
constexpr unsigned kFirstPseudoTerminal = 136;
constexpr unsigned kLastPseudoTerminal = 143;

bool isPseudoTerminal(const struct stat& status) {
    return major(status.st_rdev) >= kFirstPseudoTerminal && major(status.st_rdev) <= kLastPseudoTerminal;
}

std::string systemError() {
    return std::generic_category().message(errno);
}

} // namespace

void requireSerialPort(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0)
        throw InputError(path, errno == ENOENT ? "no such port" : systemError());
    if (!S_ISCHR(status.st_mode))
        throw InputError(path, "is not a serial port");
    if (access(path.c_str(), R_OK | W_OK) != 0)
        throw InputError(path, "cannot be opened: " + systemError());
    if (isPseudoTerminal(status))
        return;
    const FileDescriptor port(open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (port.get() < 0)
        throw InputError(path, "cannot be opened: " + systemError());
    if (isatty(port.get()) == 0)
        throw InputError(path, "is not a serial port");
}

void refuseOtherThanPort(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) == 0 && !S_ISCHR(status.st_mode))
        throw InputError(path, "is not a serial port");
}

} // namespace hexapose
