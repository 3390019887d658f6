// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace hexapose {

/// ISO 8601 in UTC with milliseconds: 2026-03-01T14:05:09.250Z.
std::string formatUtc(std::chrono::system_clock::time_point time);
/// The same read back; the fraction may have any number of digits, or be absent.
std::optional<std::chrono::system_clock::time_point> parseUtc(std::string_view text);

} // namespace hexapose
