// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace hexapose {

/// Why a text that somebody typed is not a number.
enum class TypedNumberFault {
    None,
    Empty,           ///< nothing but blanks
    Unfinished,      ///< a sign without digits, an exponent without digits
    BlankInside,     ///< "1 2"
    TwoDecimalMarks, ///< "1.2.3", and "1,234.5": no separators of thousands
    NotANumber,      ///< anything else: "abc", "0x10", "nan", "--1"
    NoSuchSize       ///< "1e999", "1e-999": too large or too small to be computed with
};

struct TypedNumber {
    double value = 0.0; ///< finite; 0 where there is a fault
    TypedNumberFault fault = TypedNumberFault::None;
    bool ok() const { return fault == TypedNumberFault::None; }
};

/// Reads what a person types (UTF-8): the whole text is understood, or the whole text is refused. The decimal
/// mark is a point or a comma; a leading sign may be '+', '-' or one of the typographic minus signs;
/// exponents, surrounding blanks and full-width characters are understood. Files and options keep to
/// parseNumber().
TypedNumber readTypedNumber(std::string_view text);

} // namespace hexapose
