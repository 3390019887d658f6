// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/row_parser.h"

#include "core/table/cell_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace hexapose {

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr int kRowsCompared = 20;
constexpr std::size_t kShown = 60; ///< characters of a cell in a problem

bool isLineEnd(char c) {
    return c == '\n' || c == '\r';
}

std::string shortened(std::string_view text) {
    if (text.size() <= kShown)
        return std::string(text);
    std::size_t size = kShown; // not within a character of several bytes
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U)
        --size;
    return std::string(text.substr(0, size)) + "...";
}

} // namespace

RowParser::RowParser(const TableFormat& format) : m_format(format), m_words(format.columns.size()) {
    m_rows.columns.resize(format.columns.size());
}

void RowParser::makeRoom(std::size_t bytes) {
    // A row has a separator or a line end for each cell at least.
    const std::size_t rows = bytes / m_format.columns.size() + 1;
    for (std::size_t i = 0; i < m_rows.columns.size(); ++i) {
        ParsedRows::Cells& cells = m_rows.columns[i];
        cells.words.clear();
        m_words[i].codes.clear();
        m_words[i].last.clear();
        m_words[i].lastCode = 0;
        const auto grow = [rows](auto& values) {
            if (values.size() < rows)
                values.resize(rows);
        };
        switch (m_format.columns[i].kind) {
        case CellKind::Number:
            grow(cells.numbers);
            break;
        case CellKind::Time:
            grow(cells.times);
            break;
        case CellKind::Word:
            grow(cells.codes);
            break;
        }
    }
}

const ParsedRows& RowParser::parse(const LineBlock& block) {
    makeRoom(block.size);
    m_rows.rowCount = 0;
    m_rows.places.clear();
    m_rows.problems.clear();
    m_rows.rowsLeftOut = m_rows.cellsMissing = m_rows.problemCount = 0;
    m_rows.lineCount = 0;
    m_text = block.text.data();
    m_offset = block.offset;
    m_isLast = block.isLast;
    const char* const end = m_text + block.size;
    for (const char* at = m_text; at < end;)
        at = parseRow(at, end);
    if (block.skipped > 0) {
        m_line = m_rows.lineCount++;
        leaveOut(Problem::Kind::LineTooLong, block.skipped);
    }
    return m_rows;
}

void RowParser::report(Problem problem) {
    ++m_rows.problemCount;
    if (m_rows.problems.size() >= ProblemList::kMost)
        return;
    problem.line = m_line;
    m_rows.problems.push_back(std::move(problem));
}

void RowParser::leaveOut(Problem::Kind kind, std::size_t count) {
    ++m_rows.rowsLeftOut;
    report({kind, 0, {}, {}, count, m_format.columns.size()});
}

/// Beyond the line end at `at`, which is counted.
const char* RowParser::skipEnd(const char* at, const char* end) {
    if (at == end)
        return at;
    ++m_rows.lineCount;
    return at + (at[0] == '\r' && at + 1 < end && at[1] == '\n' ? 2 : 1);
}

/// Returns where the next row begins. The cells are written behind those of the last row, which counts them
/// when the row is good.
const char* RowParser::parseRow(const char* begin, const char* end) {
    m_line = m_rows.lineCount;
    const std::size_t size = m_format.columns.size();
    const char separator = m_format.separator;
    const std::size_t problems = m_rows.problems.size();
    const std::uint64_t problemCount = m_rows.problemCount, cellsMissing = m_rows.cellsMissing;
    const bool points = m_format.decimalPoint == '.';
    const char* at = begin;
    std::size_t column = 0;
    bool isClosed = true, isBlank = true;
    for (;; ++column) {
        // The rule: a number, and the separator or the line end behind it.
        if (points && column < size && m_format.columns[column].kind == CellKind::Number && at < end) {
            double value = 0.0;
            const auto [stop, error] = std::from_chars(at, end, value);
            if (error == std::errc() && (stop == end || *stop == separator || isLineEnd(*stop)) &&
                std::isfinite(value)) {
                m_rows.columns[column].numbers[m_rows.rowCount] = value;
                at = stop;
                isBlank = false;
                if (at < end && *at == separator) {
                    ++at;
                    continue;
                }
                break;
            }
        }
        const char* start = at;
        while (start < end && *start == ' ')
            ++start;
        std::string_view cell;
        if (start < end && *start == '"') {
            m_unquoted.clear();
            isBlank = isClosed = false;
            for (at = start + 1; at < end; ++at) {
                if (*at == '"') {
                    if (at + 1 == end || at[1] != '"') {
                        isClosed = true;
                        break;
                    }
                    ++at;
                } else if (*at == '\n' || (*at == '\r' && (at + 1 == end || at[1] != '\n'))) {
                    ++m_rows.lineCount;
                }
                m_unquoted += *at;
            }
            at += isClosed ? 1 : 0;
            for (; at < end && *at != separator && !isLineEnd(*at);
                 ++at) // what stands behind a closing quote
                m_unquoted += *at;
            cell = m_unquoted;
        } else {
            while (at < end && *at != separator && !isLineEnd(*at))
                ++at;
            cell = {start, static_cast<std::size_t>(std::max(at, start) - start)};
            isBlank = isBlank && trimmed(cell).empty();
        }
        if (column < size)
            take(column, cell);
        if (at == end || *at != separator)
            break;
        ++at;
    }
    const std::size_t count = column + 1;
    const bool hasEnd = at < end;
    at = skipEnd(at, end);
    const auto dropRow = [&](Problem::Kind kind) {
        m_rows.problems.resize(problems);
        m_rows.problemCount = problemCount;
        m_rows.cellsMissing = cellsMissing;
        leaveOut(kind, count);
        return at;
    };
    if (isBlank && count == 1 && (size > 1 || at - begin <= 2)) {
        m_rows.problems.resize(problems);
        m_rows.problemCount = problemCount;
        m_rows.cellsMissing = cellsMissing;
        return at;
    }
    if (!isClosed)
        return dropRow(Problem::Kind::QuoteNotClosed);
    if (count < size)
        return dropRow(!hasEnd && m_isLast ? Problem::Kind::HalfWritten : Problem::Kind::TooFewFields);
    if (count > size)
        return dropRow(Problem::Kind::TooManyFields);
    if (!hasEnd && m_isLast)
        doubtLastCell(begin, end);
    const std::size_t row = m_rows.rowCount++;
    if (m_rows.places.empty() ||
        m_line - m_rows.places.back().line != static_cast<long>(row - m_rows.places.back().row))
        m_rows.places.push_back({row, m_line, m_offset + static_cast<std::uint64_t>(begin - m_text)});
    return at;
}

/// The file ends without a line end: its last cell may have lost its last characters, and then is not shown.
/// It is whole where the column has a fixed number of decimals, and this cell as many.
void RowParser::doubtLastCell(const char* begin, const char* end) {
    const auto lastCellBefore = [&](const char* lineEnd) {
        const char* at = lineEnd;
        while (at > m_text && at[-1] != m_format.separator && !isLineEnd(at[-1]))
            --at;
        return std::string_view(at, static_cast<std::size_t>(lineEnd - at));
    };
    const auto decimals = [this](std::string_view cell) {
        const std::size_t point = cell.find(m_format.decimalPoint);
        return point == std::string_view::npos ? 0 : cell.size() - point - 1;
    };
    const std::string_view cell = lastCellBefore(end);
    if (trimmed(cell).empty())
        return;
    bool isWhole = decimals(cell) > 0 && begin > m_text;
    const char* at = begin;
    for (int i = 0; i < kRowsCompared && at > m_text && isWhole; ++i) {
        while (at > m_text && isLineEnd(at[-1]))
            --at;
        const std::string_view before = lastCellBefore(at);
        isWhole = before.empty() || decimals(before) == decimals(cell);
        while (at > m_text && !isLineEnd(at[-1]))
            --at;
    }
    if (isWhole)
        return;
    const std::size_t last = m_format.columns.size() - 1;
    ParsedRows::Cells& cells = m_rows.columns[last];
    const ColumnInfo& info = m_format.columns[last];
    if (info.kind == CellKind::Number)
        cells.numbers[m_rows.rowCount] = kMissing;
    else if (info.kind == CellKind::Time)
        cells.times[m_rows.rowCount] = kNoTime;
    else
        cells.codes[m_rows.rowCount] = 0;
    ++m_rows.cellsMissing;
    report({Problem::Kind::HalfWritten, 0, info.name, shortened(trimmed(cell))});
}

void RowParser::take(std::size_t column, std::string_view cell) {
    const ColumnInfo& info = m_format.columns[column];
    ParsedRows::Cells& cells = m_rows.columns[column];
    cell = trimmed(cell);
    switch (info.kind) {
    case CellKind::Number: {
        const std::optional<double> value = parseCell(cell, m_format.decimalPoint);
        cells.numbers[m_rows.rowCount] = value.value_or(kMissing);
        if (!value && !cell.empty()) {
            ++m_rows.cellsMissing;
            report({Problem::Kind::NotANumber, 0, info.name, shortened(cell)});
        }
        break;
    }
    case CellKind::Time: {
        const std::optional<std::int64_t> time = parseTime(cell, info.timeText, m_format.decimalPoint);
        cells.times[m_rows.rowCount] = time.value_or(kNoTime);
        if (!time && !cell.empty()) {
            ++m_rows.cellsMissing;
            report({Problem::Kind::NotATime, 0, info.name, shortened(cell)});
        }
        break;
    }
    case CellKind::Word:
        takeWord(column, cell);
        break;
    }
}

void RowParser::takeWord(std::size_t column, std::string_view cell) {
    ParsedRows::Cells& cells = m_rows.columns[column];
    Words& words = m_words[column];
    if (cell.empty()) {
        cells.codes[m_rows.rowCount] = 0;
        return;
    }
    if (words.lastCode == 0 || cell != words.last) { // words mostly stay as they are
        words.last = cell;
        const auto [found, isNew] =
            words.codes.try_emplace(words.last, static_cast<std::uint32_t>(cells.words.size()) + 1);
        if (isNew)
            cells.words.push_back(words.last);
        words.lastCode = found->second;
    }
    cells.codes[m_rows.rowCount] = words.lastCode;
}

} // namespace hexapose
