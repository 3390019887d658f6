// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/mechanism.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace hexapose {

/// Reads the description of a mechanism (TOML, format 1, see README.md here; mm and degrees there, m and rad
/// in the result). Throws InputError "file:line: cause" for a file that cannot be read, bad TOML, an unknown
/// format number, an unknown or missing key, a wrong type, a number that is none, a name that is unknown or
/// given twice, an unknown kind, or joints that coincide. Whether the equations are square and of full rank
/// StepSystem finds out.
Mechanism loadMechanism(const std::filesystem::path& file);

/// The same from text; sourceName stands for the file in messages.
Mechanism parseMechanism(std::string_view toml, const std::string& sourceName);

} // namespace hexapose
