// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hexapose {

/// Shortest decimal text that reads back to the same double; always with '.', whatever the locale. "nan",
/// "inf".
std::string formatNumber(double value);

/// The same as a TOML float: never an integer, so that -0 and 1e20 survive too.
std::string formatTomlNumber(double value);

/// Fixed number of decimals, '.', no "-0.0".
std::string formatFixed(double value, int decimals);

/// The whole text as a finite or non-finite double, '.' only, blanks around it allowed; nothing for anything
/// else.
std::optional<double> parseNumber(std::string_view text);

/// The whole text as an integer.
std::optional<long long> parseInteger(std::string_view text);

} // namespace hexapose
