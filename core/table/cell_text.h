// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/column.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace hexapose {

/// The whole text as a finite number with this decimal point, blanks around it and a plus sign allowed.
/// Nothing for anything else, "nan", "1,000.5" and a number beyond the range of doubles among it.
std::optional<double> parseCell(std::string_view text, char decimalPoint);

/// Decimal text as a whole number of nanoseconds, `nsPerUnit` of them to 1: exactly, as far as it has no more
/// digits than these; further ones are rounded. Nothing for other text, or beyond 64 bits.
std::optional<std::int64_t> parseDecimalTime(std::string_view text, char decimalPoint,
                                             std::int64_t nsPerUnit);

/// "2026-11-29T12:00:00.123456789Z" as nanoseconds since 1970: 'T' or blanks between date and time, seconds
/// and fraction optional, "Z", "+01:00", "+0100" or no zone, which is taken for UTC; a date alone.
std::optional<std::int64_t> parseIsoTime(std::string_view text);

/// As a column of times is written.
std::optional<std::int64_t> parseTime(std::string_view text, TimeText form, char decimalPoint);

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

} // namespace hexapose
