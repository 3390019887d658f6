// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/column_summary.h"

#include "core/base/number_text.h"
#include "core/table/statistics.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace hexapose {

namespace {

std::string numberText(double value) {
    return std::isnan(value) ? "" : formatNumber(value);
}

std::int64_t nanosecondsPer(TimeText form) {
    switch (form) {
    case TimeText::Millis:
        return 1'000'000;
    case TimeText::Micros:
        return 1'000;
    case TimeText::Nanos:
        return 1;
    case TimeText::Seconds:
    case TimeText::Iso:
        break;
    }
    return 1'000'000'000;
}

/// Digits behind the point without zeros at the end.
std::string fractionText(std::int64_t rest, std::int64_t unit) {
    std::string digits;
    for (unit /= 10; rest > 0; unit /= 10) {
        digits += static_cast<char>('0' + rest / unit);
        rest %= unit;
    }
    return digits.empty() ? "" : "." + digits;
}

std::string isoText(std::int64_t nanoseconds) {
    using namespace std::chrono;
    const sys_time<std::chrono::nanoseconds> time{std::chrono::nanoseconds(nanoseconds)};
    const auto day = floor<days>(time);
    const year_month_day date(day);
    const hh_mm_ss clock(time - day);
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                  static_cast<int>(clock.seconds().count()));
    return text.data() + fractionText(clock.subseconds().count(), 1'000'000'000) + "Z";
}

ColumnSummary ofNumbers(const Column& column, const std::vector<RowRange>& rows) {
    const Statistics numbers = statisticsOf(column, rows);
    return {numbers.count,           numbers.missing,           numberText(numbers.min),
            numberText(numbers.max), numberText(numbers.mean),  numberText(numbers.sigma),
            numberText(numbers.rms), numberText(numbers.first), numberText(numbers.last)};
}

ColumnSummary ofTimes(const Column& column, const std::vector<RowRange>& rows) {
    ColumnSummary summary;
    const TimeText form = column.info().timeText;
    std::int64_t first = kNoTime, last = kNoTime, min = kNoTime, max = kNoTime;
    double sum = 0.0, squares = 0.0;
    for (const RowRange& range : rows) {
        for (Row row = range.begin; row < range.end; ++row) {
            const std::int64_t time = column.time(row);
            if (time == kNoTime) {
                ++summary.missing;
                continue;
            }
            if (summary.count++ == 0)
                first = min = max = time;
            min = std::min(min, time);
            max = std::max(max, time);
            last = time;
            const double fromFirst = secondsBetween(first, time);
            sum += fromFirst;
            squares += fromFirst * fromFirst;
        }
    }
    if (summary.count == 0)
        return summary;
    summary.min = timeText(min, form);
    summary.max = timeText(max, form);
    summary.first = timeText(first, form);
    summary.last = timeText(last, form);
    if (form == TimeText::Iso)
        return summary;
    const auto count = static_cast<double>(summary.count);
    const double unit = 1e9 / static_cast<double>(nanosecondsPer(form));
    const double mean = sum / count, base = 1e-9 * static_cast<double>(first);
    summary.mean = numberText(unit * (base + mean));
    if (summary.count > 1)
        summary.sigma =
            numberText(unit * std::sqrt(std::max(0.0, squares - count * mean * mean) / (count - 1.0)));
    summary.rms =
        numberText(unit * std::sqrt(std::max(0.0, squares / count + 2.0 * base * mean + base * base)));
    return summary;
}

ColumnSummary ofWords(const Column& column, const std::vector<RowRange>& rows) {
    ColumnSummary summary;
    for (const RowRange& range : rows) {
        for (Row row = range.begin; row < range.end; ++row) {
            const std::string_view word = column.word(row);
            if (word.empty()) {
                ++summary.missing;
                continue;
            }
            if (summary.count++ == 0)
                summary.first = word;
            summary.last = word;
        }
    }
    return summary;
}

} // namespace

std::string timeText(std::int64_t nanoseconds, TimeText form) {
    if (form == TimeText::Iso)
        return isoText(nanoseconds);
    const std::int64_t unit = nanosecondsPer(form);
    const std::int64_t whole = nanoseconds / unit, rest = nanoseconds % unit;
    const bool negative = nanoseconds < 0 && whole == 0;
    return (negative ? "-" : "") + std::to_string(whole) + fractionText(rest < 0 ? -rest : rest, unit);
}

ColumnSummary summarize(const Column& column, const std::vector<RowRange>& rows) {
    switch (column.info().kind) {
    case CellKind::Number:
        return ofNumbers(column, rows);
    case CellKind::Time:
        return ofTimes(column, rows);
    case CellKind::Word:
        return ofWords(column, rows);
    }
    return {};
}

} // namespace hexapose
