// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stop_token>

namespace hexapose {

/// Makes the new file `to` of `from`, compressed by gzip, and returns once it is on the disk. False, and then
/// no `to`, when it is stopped, when something cannot be read or written, or when `to` exists already, which
/// is left as it is.
bool gzipFile(const std::filesystem::path& from, const std::filesystem::path& to,
              const std::stop_token& stop);

} // namespace hexapose
