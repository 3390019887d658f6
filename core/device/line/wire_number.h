// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Numbers as the line protocol writes them, whatever the locale.
namespace hexapose::line {

inline constexpr int kMaxDecimals = 6;

/// An optional '-', digits, and at most six decimals behind a '.': nothing else, and finite.
std::optional<double> parseWireDecimal(std::string_view text);

/// An optional '-' and digits that fit 64 bits.
std::optional<long long> parseWireInteger(std::string_view text);

/// With as few decimals as it takes, at most six; never an exponent or "-0". The value must be finite.
std::string formatWireDecimal(double value);

} // namespace hexapose::line
