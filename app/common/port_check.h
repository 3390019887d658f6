// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hexapose {

/// A port that was asked for by an option must be there. Throws InputError when nothing has this path, when
/// it is not a serial port, and when it cannot be opened (permission, in use). A port that goes away later is
/// waited for instead.
void requireSerialPort(const std::string& path);

/// A port may come later, but not where something else is. Throws InputError when the path is that of a file,
/// a directory or the like.
void refuseOtherThanPort(const std::string& path);

} // namespace hexapose
