// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hexapose {

/// With its parents. Throws InputError when it cannot be made.
void makeDirectory(const std::filesystem::path& directory);
/// $XDG_CACHE_HOME/hexapose, or ~/.cache/hexapose.
std::filesystem::path cacheDirectory();
/// $XDG_DATA_HOME/hexapose/logs, or ~/.local/share/hexapose/logs.
std::filesystem::path defaultLogDirectory();
/// Finds a shipped platform file by name ("laboratory") beside the program's installation, its build tree, or
/// returns the argument itself when it names a file. Throws InputError with the places searched.
std::filesystem::path findPlatformFile(const std::string& nameOrFile);
/// The same for a mechanism file ("6-ups").
std::filesystem::path findMechanismFile(const std::string& nameOrFile);
/// The names that come with the program in one of these folders, "platforms" or "mechanisms", sorted.
std::vector<std::string> shippedNames(const std::string& folder);

} // namespace hexapose
