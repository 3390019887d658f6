// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace hexapose {

/// Every byte of a file. Throws InputError "file: cannot be read" for one that is missing, forbidden or a
/// directory.
std::string readTextFile(const std::filesystem::path& file);

} // namespace hexapose
