// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/chunked.h"
#include "core/table/min_max_pyramid.h"
#include "core/table/time_axis.h"
#include "core/table/word_list.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace hexapose {

/// What the cells of a column are.
enum class CellKind {
    Number, ///< a double in the file's own unit; NaN: missing
    Word,   ///< text, stored as a code
    Time,   ///< nanoseconds, exact; of the day's epoch where the file has dates, else of the file's own zero
};

/// How a column of times is written.
enum class TimeText {
    Iso,     ///< 2026-11-29T12:00:00.123Z, with a zone, or as written (then taken for UTC)
    Seconds, ///< of the file's own zero, or since 1970 where the numbers are as large
    Millis,
    Micros,
    Nanos,
};

/// What a column is called, and how it is written.
struct ColumnInfo {
    std::string name;  ///< of the header, trimmed and unique in its file: "l1_mm", "event", "x (2)"
    std::string label; ///< without its unit: "l1"
    std::string unit;  ///< "mm", "deg", "s", "%"; empty: none, or not known
    CellKind kind = CellKind::Number;
    TimeText timeText = TimeText::Seconds; ///< of a column of times
};

/// One column of a table, or of the part of it that has been read. A value: copies share the cells.
class Column {
public:
    explicit Column(ColumnInfo info) : m_info(std::move(info)) {}
    /// Of numbers that were worked out from other columns; the pyramid is theirs.
    Column(ColumnInfo info, Chunked<double> numbers, MinMaxPyramid pyramid)
        : m_info(std::move(info)), m_numbers(std::move(numbers)), m_pyramid(std::move(pyramid)) {}

    const ColumnInfo& info() const { return m_info; }
    bool isNumber() const { return m_info.kind == CellKind::Number; }

    /// Of a column of numbers: NaN where the cell is missing. Of times: seconds from `origin`.
    double number(Row row, std::int64_t origin = 0) const;
    /// Of a column of words: empty where the cell is.
    std::string_view word(Row row) const;
    std::uint32_t code(Row row) const { return m_codes[row]; }
    std::string_view wordOf(std::uint32_t code) const { return m_words.at(code); }
    /// Of a column of times; kNoTime where the cell is missing.
    std::int64_t time(Row row) const { return m_times[row]; }

    /// Smallest and largest number of the rows [begin, end), exactly those of a search through all of them;
    /// a column of numbers. NaN where all are missing.
    MinMax range(Row begin, Row end) const { return m_pyramid.range(m_numbers, begin, end); }

    const Chunked<double>& numbers() const { return m_numbers; }

private:
    friend class TableBuilder;
    ColumnInfo m_info;
    Chunked<double> m_numbers;
    Chunked<std::uint32_t> m_codes;
    Chunked<std::int64_t> m_times;
    WordList m_words;
    MinMaxPyramid m_pyramid;
};

} // namespace hexapose
