// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/typed_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

namespace hexapose {

namespace {

struct Spelling {
    std::string_view utf8;
    char meaning;
};

/// What keyboards, input methods and copied texts put in place of the plain characters.
constexpr Spelling kSpellings[] = {
    {"\u2212", '-'}, // minus sign
    {"\u2010", '-'}, // hyphen
    {"\u2011", '-'}, // non-breaking hyphen
    {"\u2012", '-'}, // figure dash
    {"\u2013", '-'}, // en dash
    {"\uFE63", '-'}, // small hyphen-minus
    {"\uFF0D", '-'}, // full-width hyphen-minus
    {"\uFF0B", '+'}, // full-width plus sign
    {"\uFF0E", '.'}, // full-width full stop
    {"\uFF0C", ','}, // full-width comma
    {"\u00A0", ' '}, // no-break space
    {"\u2007", ' '}, // figure space
    {"\u2009", ' '}, // thin space
    {"\u202F", ' '}, // narrow no-break space
    {"\u3000", ' '}, // ideographic space
};
constexpr std::string_view kFullWidthZero = "\uFF10"; // the other nine follow in the last byte

/// The character at the head of the text in plain ASCII, and how many bytes it takes; '?' for any other.
std::pair<char, std::size_t> headOf(std::string_view text) {
    const char first = text.front();
    if (static_cast<unsigned char>(first) < 0x80)
        return {first == '\t' || first == '\r' || first == '\n' ? ' ' : first, 1};
    for (const Spelling& one : kSpellings)
        if (text.starts_with(one.utf8))
            return {one.meaning, one.utf8.size()};
    if (text.size() >= kFullWidthZero.size() && text.starts_with(kFullWidthZero.substr(0, 2))) {
        const int digit = static_cast<unsigned char>(text[2]) - static_cast<unsigned char>(kFullWidthZero[2]);
        if (digit >= 0 && digit <= 9)
            return {static_cast<char>('0' + digit), kFullWidthZero.size()};
    }
    return {'?', 1};
}

std::string plain(std::string_view text) {
    std::string ascii;
    while (!text.empty()) {
        const auto [character, bytes] = headOf(text);
        ascii += character;
        text.remove_prefix(bytes);
    }
    return ascii;
}

std::string_view withoutBlankEnds(std::string_view text) {
    const auto first = text.find_first_not_of(' ');
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

bool takeSign(std::string_view& text) {
    const bool sign = text.starts_with('+') || text.starts_with('-');
    if (sign)
        text.remove_prefix(1);
    return sign;
}

std::size_t takeDigits(std::string_view& text) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    text.remove_prefix(digits);
    return digits;
}

bool isDecimalMark(char c) {
    return c == '.' || c == ',';
}

/// What is wrong with the form of a text without blanks around it.
TypedNumberFault faultOf(std::string_view text) {
    using Fault = TypedNumberFault;
    if (text.empty())
        return Fault::Empty;
    const bool numerals = text.find_first_not_of("0123456789.,+-eE ") == std::string_view::npos;
    if (numerals && text.find(' ') != std::string_view::npos)
        return Fault::BlankInside;
    if (numerals && std::count_if(text.begin(), text.end(), isDecimalMark) > 1)
        return Fault::TwoDecimalMarks;
    takeSign(text);
    std::size_t digits = takeDigits(text);
    if (!text.empty() && isDecimalMark(text.front())) {
        text.remove_prefix(1);
        digits += takeDigits(text);
    }
    if (digits == 0)
        return text.empty() ? Fault::Unfinished : Fault::NotANumber;
    if (text.empty())
        return Fault::None;
    if (text.front() != 'e' && text.front() != 'E')
        return Fault::NotANumber;
    text.remove_prefix(1);
    takeSign(text);
    if (takeDigits(text) == 0)
        return text.empty() ? Fault::Unfinished : Fault::NotANumber;
    return text.empty() ? Fault::None : Fault::NotANumber;
}

} // namespace

TypedNumber readTypedNumber(std::string_view text) {
    const std::string ascii = plain(text);
    std::string number(withoutBlankEnds(ascii));
    if (const TypedNumberFault fault = faultOf(number); fault != TypedNumberFault::None)
        return {0.0, fault};
    std::replace(number.begin(), number.end(), ',', '.');
    std::string_view rest = number;
    if (rest.starts_with('+')) // from_chars knows none in front
        rest.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error != std::errc{} || !std::isfinite(value))
        return {0.0, TypedNumberFault::NoSuchSize};
    if (end != rest.data() + rest.size())
        return {0.0, TypedNumberFault::NotANumber};
    return {value, TypedNumberFault::None};
}

} // namespace hexapose
