// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/utc_text.h"

#include "core/base/number_text.h"

#include <array>
#include <cstdio>

namespace hexapose {

namespace {

/// A run of digits of fixed width; -1 for anything else.
int digits(std::string_view text, std::size_t from, std::size_t width) {
    int value = 0;
    for (const char c : text.substr(from, width)) {
        if (c < '0' || c > '9')
            return -1;
        value = value * 10 + (c - '0');
    }
    return value;
}

} // namespace

std::string formatUtc(std::chrono::system_clock::time_point time) {
    using namespace std::chrono;
    const auto stamp = floor<milliseconds>(time);
    const auto day = floor<days>(stamp);
    const year_month_day date(day);
    const hh_mm_ss clock(stamp - day);
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ",
                  static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                  static_cast<unsigned>(date.day()), static_cast<int>(clock.hours().count()),
                  static_cast<int>(clock.minutes().count()), static_cast<int>(clock.seconds().count()),
                  static_cast<int>(clock.subseconds().count()));
    return text.data();
}

std::optional<std::chrono::system_clock::time_point> parseUtc(std::string_view text) {
    using namespace std::chrono;
    constexpr std::string_view kShape = "dddd-dd-ddTdd:dd:dd";
    if (text.size() <= kShape.size() || text.back() != 'Z')
        return std::nullopt;
    for (std::size_t i = 0; i < kShape.size(); ++i)
        if (kShape[i] == 'd' ? (text[i] < '0' || text[i] > '9') : text[i] != kShape[i])
            return std::nullopt;
    const year_month_day date(year(digits(text, 0, 4)), month(static_cast<unsigned>(digits(text, 5, 2))),
                              day(static_cast<unsigned>(digits(text, 8, 2))));
    const int hour = digits(text, 11, 2);
    const int minute = digits(text, 14, 2);
    const int second = digits(text, 17, 2);
    if (!date.ok() || hour > 23 || minute > 59 || second > 60)
        return std::nullopt;
    auto time = time_point_cast<system_clock::duration>(sys_days(date)) + hours(hour) + minutes(minute) +
                seconds(second);
    const std::string_view fraction = text.substr(kShape.size(), text.size() - kShape.size() - 1);
    if (!fraction.empty()) {
        if (fraction.size() < 2 || fraction.front() != '.' ||
            fraction.find_first_not_of("0123456789", 1) != std::string_view::npos)
            return std::nullopt;
        const std::optional<double> part = parseNumber("0" + std::string(fraction));
        time += round<system_clock::duration>(duration<double>(part.value_or(0.0)));
    }
    return time;
}

} // namespace hexapose
