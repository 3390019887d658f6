// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace hexapose {

/// Reads a platform file (TOML, format 1; mm there, m in the result). Throws InputError "file:line: cause"
/// for a file that cannot be read, bad TOML, an unknown format number, an unknown or missing key, a wrong
/// type, a wrong leg count, or a geometry that validate() refuses.
PlatformGeometry loadPlatform(const std::filesystem::path& file);

/// The same from text; sourceName stands for the file in messages. Throws the same but for reading.
PlatformGeometry parsePlatform(std::string_view toml, const std::string& sourceName);

/// The platform file of a geometry, in mm; parsePlatform() of it gives the same doubles back. Checks nothing.
std::string formatPlatform(const PlatformGeometry& geometry);

} // namespace hexapose
