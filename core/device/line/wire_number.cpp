// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/wire_number.h"

#include "core/base/number_text.h"

#include <charconv>
#include <cmath>

namespace hexapose::line {

namespace {

std::size_t digitCount(std::string_view text) {
    const std::size_t end = text.find_first_not_of("0123456789");
    return end == std::string_view::npos ? text.size() : end;
}

std::string_view withoutMinus(std::string_view text) {
    if (text.starts_with('-'))
        text.remove_prefix(1);
    return text;
}

} // namespace

std::optional<double> parseWireDecimal(std::string_view text) {
    const std::string_view digits = withoutMinus(text);
    const std::size_t whole = digitCount(digits);
    if (whole == 0)
        return std::nullopt;
    if (whole < digits.size()) {
        if (digits[whole] != '.')
            return std::nullopt;
        const std::string_view decimals = digits.substr(whole + 1);
        if (decimals.empty() || decimals.size() > kMaxDecimals || digitCount(decimals) != decimals.size())
            return std::nullopt;
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::optional<long long> parseWireInteger(std::string_view text) {
    const std::string_view digits = withoutMinus(text);
    if (digits.empty() || digitCount(digits) != digits.size())
        return std::nullopt;
    long long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{})
        return std::nullopt;
    return value;
}

std::string formatWireDecimal(double value) {
    std::string text = formatFixed(value, kMaxDecimals);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.ends_with('.'))
            text.pop_back();
    }
    return text;
}

} // namespace hexapose::line
