// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/time_axis.h"

#include "core/table/column.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapose {

double secondsBetween(std::int64_t from, std::int64_t to) {
    // Far apart, as near the ends of 64 bits, the difference itself does not fit any more.
    std::int64_t difference = 0;
    if (__builtin_sub_overflow(to, from, &difference))
        return 1e-9 * (static_cast<double>(to) - static_cast<double>(from));
    return static_cast<double>(difference) / 1e9;
}

std::int64_t TimeAxis::nanoseconds(Row row) const {
    if (!m_hasTime)
        return static_cast<std::int64_t>(row) * 1'000'000'000;
    const std::int64_t time = m_times[row];
    std::int64_t difference = 0;
    return time == kNoTime || __builtin_sub_overflow(time, m_originNs, &difference) ? kNoTime : difference;
}

double TimeAxis::seconds(Row row) const {
    if (!m_hasTime)
        return static_cast<double>(row);
    const std::int64_t time = m_times[row];
    return time == kNoTime ? std::numeric_limits<double>::quiet_NaN() : secondsBetween(m_originNs, time);
}

namespace {

/// The first row of [begin, end) whose time is not `isBefore`; rows without a time go with the one after.
template <typename Before>
Row partition(const TimeAxis& axis, Row begin, Row end, Before isBefore) {
    while (begin < end) {
        const Row middle = begin + (end - begin) / 2;
        Row timed = middle;
        while (timed < end && std::isnan(axis.seconds(timed)))
            ++timed;
        if (timed < end && isBefore(axis.seconds(timed)))
            begin = timed + 1;
        else
            end = middle;
    }
    return begin;
}

} // namespace

Row TimeAxis::firstAtOrAfter(const Run& run, double seconds) const {
    return partition(*this, run.begin, run.end, [seconds](double time) { return time < seconds; });
}

Row TimeAxis::firstAfter(const Run& run, double seconds) const {
    return partition(*this, run.begin, run.end, [seconds](double time) { return time <= seconds; });
}

std::vector<RowRange> TimeAxis::rowsBetween(double begin, double end) const {
    std::vector<RowRange> ranges;
    for (const Run& run : m_runs) {
        const RowRange range{firstAtOrAfter(run, begin), firstAfter(run, end)};
        if (range.begin < range.end)
            ranges.push_back(range);
    }
    return ranges;
}

std::optional<Row> TimeAxis::lastAtOrBefore(double seconds) const {
    for (std::size_t i = m_runs.size(); i-- > 0;) {
        Row row = firstAfter(m_runs[i], seconds);
        while (row > m_runs[i].begin) {
            --row;
            if (!std::isnan(this->seconds(row)))
                return row;
        }
    }
    return std::nullopt;
}

} // namespace hexapose
