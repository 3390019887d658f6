// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/chunked.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace hexapose {

inline constexpr std::int64_t kNoTime = INT64_MIN; ///< a missing cell of a column of times

/// The rows [begin, end).
struct RowRange {
    Row begin = 0, end = 0;
    bool operator==(const RowRange&) const = default;
};

/// Seconds from one time to another, in nanoseconds: of any two.
double secondsBetween(std::int64_t from, std::int64_t to);

/// The time of each row of a table. Seconds from the origin: the file's own zero; where times are dates, the
/// first row that has one. Where the file has no time, the number of the row from 0.
class TimeAxis {
public:
    using Run = RowRange; ///< of rows in which time does not go back

    bool hasTime() const { return m_hasTime; }
    bool isCalendar() const { return m_isCalendar; } ///< the times are dates: origin is since 1970, UTC
    std::int64_t originNs() const { return m_originNs; }
    std::optional<std::size_t> column() const { return m_column; } ///< of the table, that it comes from
    Row rowCount() const { return m_rowCount; }
    /// One run where time never goes back, which is the rule.
    const std::vector<Run>& runs() const { return m_runs; }

    /// NaN where the row's time is missing.
    double seconds(Row row) const;
    std::int64_t nanoseconds(Row row) const; ///< from the origin; kNoTime where missing
    double begin() const { return m_begin; } ///< s; smallest and largest of all rows
    double end() const { return m_end; }
    /// The usual distance of two rows, s: the median over the first thousands; 0 when not known.
    double usualStep() const { return m_usualStep; }

    /// Within a run, the first row at or after a time, and the first one after it: binary searches, which
    /// pass over missing times.
    Row firstAtOrAfter(const Run& run, double seconds) const;
    Row firstAfter(const Run& run, double seconds) const;
    /// The rows of all runs from a time to another, both included, in file order.
    std::vector<RowRange> rowsBetween(double begin, double end) const;
    /// The last row at or before a time, in file order; nothing before the first one.
    std::optional<Row> lastAtOrBefore(double seconds) const;

private:
    friend class TableBuilder;
    bool m_hasTime = false, m_isCalendar = false;
    std::int64_t m_originNs = 0;
    std::optional<std::size_t> m_column;
    Row m_rowCount = 0;
    Chunked<std::int64_t> m_times;
    std::vector<Run> m_runs;
    double m_begin = 0.0, m_end = 0.0, m_usualStep = 0.0;
};

} // namespace hexapose
