// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/cell_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>

namespace hexapose {

namespace {

constexpr std::size_t kLongestNumber = 400; ///< characters; 1e308 written out has 309

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Takes digits from the front of a text.
class Digits {
public:
    explicit Digits(std::string_view text) : m_rest(text) {}
    bool isEmpty() const { return m_rest.empty(); }
    char front() const { return m_rest.empty() ? '\0' : m_rest.front(); }
    bool skip(char c) {
        if (front() != c)
            return false;
        m_rest.remove_prefix(1);
        return true;
    }
    /// Exactly so many digits.
    std::optional<int> take(std::size_t count) {
        int value = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (i >= m_rest.size() || !isDigit(m_rest[i]))
                return std::nullopt;
            value = 10 * value + (m_rest[i] - '0');
        }
        m_rest.remove_prefix(count);
        return value;
    }
    /// All digits that follow, as a fraction in nanoseconds.
    std::int64_t takeFraction() {
        std::int64_t value = 0, unit = 100'000'000;
        for (; isDigit(front()); m_rest.remove_prefix(1), unit /= 10)
            value += unit * (front() - '0');
        return value;
    }

private:
    std::string_view m_rest;
};

/// After the time of day; minutes east. Nothing for a zone that is none.
std::optional<int> takeZone(Digits& text) {
    if (text.isEmpty() || text.skip('Z') || text.skip('z'))
        return 0;
    const bool east = text.front() == '+';
    if (!text.skip('+') && !text.skip('-'))
        return std::nullopt;
    const auto hours = text.take(2);
    const bool colon = text.skip(':');
    const auto minutes = text.isEmpty() && !colon ? std::optional(0) : text.take(2);
    if (!hours || !minutes || *hours > 23 || *minutes > 59)
        return std::nullopt;
    return (east ? 1 : -1) * (60 * *hours + *minutes);
}

std::optional<std::int64_t> inNanoseconds(std::int64_t seconds, std::int64_t fraction) {
    std::int64_t result = 0;
    if (__builtin_mul_overflow(seconds, std::int64_t{1'000'000'000}, &result) ||
        __builtin_add_overflow(result, fraction, &result))
        return std::nullopt;
    return result;
}

std::optional<std::int64_t> rounded(double value) {
    constexpr double kMost = 9.2e18;
    if (!(std::abs(value) < kMost))
        return std::nullopt;
    return std::llround(value);
}

} // namespace

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t'))
        text.remove_suffix(1);
    return text;
}

std::optional<double> parseCell(std::string_view text, char decimalPoint) {
    text = trimmed(text);
    std::array<char, kLongestNumber> buffer;
    if (decimalPoint != '.' && text.find(decimalPoint) != std::string_view::npos) {
        if (text.size() > buffer.size() || text.find('.') != std::string_view::npos)
            return std::nullopt;
        std::replace_copy(text.begin(), text.end(), buffer.begin(), decimalPoint, '.');
        text = {buffer.data(), text.size()};
    }
    if (text.size() > 1 && text.front() == '+' && text[1] != '-')
        text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::optional<std::int64_t> parseDecimalTime(std::string_view text, char decimalPoint,
                                             std::int64_t nsPerUnit) {
    text = trimmed(text);
    std::string_view rest = text;
    const bool negative = !rest.empty() && rest.front() == '-';
    if (!rest.empty() && (rest.front() == '-' || rest.front() == '+'))
        rest.remove_prefix(1);
    std::int64_t value = 0;
    std::size_t digits = 0;
    for (; !rest.empty() && isDigit(rest.front()); rest.remove_prefix(1), ++digits)
        if (__builtin_mul_overflow(value, std::int64_t{10}, &value) ||
            __builtin_add_overflow(value, std::int64_t{rest.front() - '0'}, &value))
            return std::nullopt;
    if (__builtin_mul_overflow(value, nsPerUnit, &value))
        return std::nullopt;
    if (!rest.empty() && (rest.front() == decimalPoint || rest.front() == '.')) {
        rest.remove_prefix(1);
        for (std::int64_t unit = nsPerUnit / 10; !rest.empty() && isDigit(rest.front());
             rest.remove_prefix(1), ++digits) {
            const int digit = rest.front() - '0';
            if (unit == 0) { // the first digit that is too fine rounds
                value += digit >= 5 ? 1 : 0;
                unit = -1;
            } else if (unit > 0 && __builtin_add_overflow(value, unit * digit, &value)) {
                return std::nullopt;
            }
            unit = unit == 1 ? 0 : unit > 0 ? unit / 10 : unit;
        }
    }
    if (digits == 0)
        return std::nullopt;
    if (rest.empty())
        return negative ? -value : value;
    const auto number = parseCell(text, decimalPoint); // with an exponent, or not a number at all
    return number ? rounded(*number * static_cast<double>(nsPerUnit)) : std::nullopt;
}

std::optional<std::int64_t> parseIsoTime(std::string_view text) {
    using namespace std::chrono;
    Digits rest(trimmed(text));
    const auto year = rest.take(4);
    if (!year || !rest.skip('-'))
        return std::nullopt;
    const auto month = rest.take(2);
    if (!month || !rest.skip('-'))
        return std::nullopt;
    const auto day = rest.take(2);
    if (!day)
        return std::nullopt;
    const year_month_day date{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                              std::chrono::day(static_cast<unsigned>(*day))};
    if (!date.ok())
        return std::nullopt;
    const std::int64_t midnight = sys_days(date).time_since_epoch().count() * std::int64_t{86400};
    if (rest.isEmpty())
        return inNanoseconds(midnight, 0);
    if (!rest.skip('T') && !rest.skip('t') && !rest.skip(' '))
        return std::nullopt;
    while (rest.skip(' ')) {
    }
    const auto hour = rest.take(2);
    if (!hour || !rest.skip(':'))
        return std::nullopt;
    const auto minute = rest.take(2);
    if (!minute)
        return std::nullopt;
    std::optional<int> second = 0;
    std::int64_t fraction = 0;
    if (rest.skip(':')) {
        second = rest.take(2);
        if (rest.skip('.') || rest.skip(','))
            fraction = rest.takeFraction();
    }
    while (rest.skip(' ')) {
    }
    const auto east = takeZone(rest);
    if (!second || !east || !rest.isEmpty() || *hour > 23 || *minute > 59 || *second > 60)
        return std::nullopt;
    return inNanoseconds(midnight + 3600 * *hour + 60 * (*minute - *east) + *second, fraction);
}

std::optional<std::int64_t> parseTime(std::string_view text, TimeText form, char decimalPoint) {
    switch (form) {
    case TimeText::Iso:
        return parseIsoTime(text);
    case TimeText::Seconds:
        return parseDecimalTime(text, decimalPoint, 1'000'000'000);
    case TimeText::Millis:
        return parseDecimalTime(text, decimalPoint, 1'000'000);
    case TimeText::Micros:
        return parseDecimalTime(text, decimalPoint, 1'000);
    case TimeText::Nanos:
        return parseDecimalTime(text, decimalPoint, 1);
    }
    return std::nullopt;
}

} // namespace hexapose
