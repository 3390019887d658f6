// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/table_format.h"

#include "core/base/input_error.h"
#include "core/table/cell_text.h"
#include "core/table/column_unit.h"
#include "core/table/record_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace hexapose {

namespace {

constexpr std::size_t kSampleRows = 1000;
constexpr std::size_t kSeparatorRows = 50;
using Fields = std::vector<std::string>;

bool isComment(std::string_view line) {
    line = trimmed(line);
    return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

/// Blank lines and comments at the beginning.
struct Start {
    std::size_t offset = 0;
    long line = 1;
    std::string lastComment; ///< without its mark
};

Start skipComments(std::string_view text) {
    Start start;
    RecordScanner lines(text, '\0'); // which no text holds: a record is a line
    while (lines.next()) {
        if (!lines.isBlank() && !isComment(lines.text()))
            break;
        start.offset = lines.rest();
        start.line = lines.restLine();
        if (!lines.isBlank()) {
            const std::string_view comment = trimmed(lines.text());
            start.lastComment =
                trimmed(comment.substr(comment.find_first_not_of("#%/") == std::string_view::npos
                                           ? comment.size()
                                           : comment.find_first_not_of("#%/")));
        }
    }
    return start;
}

/// The separator by which the first rows have most often the number of fields of the first one, which is
/// more than one.
char findSeparator(std::string_view text) {
    char best = ',';
    std::size_t bestRows = 0, bestFields = 1;
    for (const char candidate : {',', ';', '\t', '|'}) {
        RecordScanner records(text, candidate);
        std::map<std::size_t, std::size_t> rowsOf;
        std::size_t first = 0;
        for (std::size_t i = 0; i < kSeparatorRows && records.next();) {
            if (records.isBlank())
                continue;
            first = i == 0 ? records.fields().size() : first;
            ++rowsOf[records.fields().size()];
            ++i;
        }
        // With decimal commas, commas part numbers too, though hardly ever the words of the header.
        const std::size_t rows = first > 1 ? rowsOf[first] : 0;
        if (rows > bestRows || (rows == bestRows && rows > 0 && first > bestFields)) {
            best = candidate;
            bestRows = rows;
            bestFields = first;
        }
    }
    return best;
}

bool isDecimalComma(std::string_view cell) {
    cell = trimmed(cell);
    return std::count(cell.begin(), cell.end(), ',') == 1 && parseCell(cell, ',').has_value();
}

char findDecimalPoint(const std::vector<Fields>& rows, char separator) {
    if (separator == ',')
        return '.';
    std::size_t commas = 0, points = 0;
    for (const Fields& row : rows) {
        for (const std::string& cell : row) {
            commas += isDecimalComma(cell) ? 1U : 0U;
            points += cell.find('.') != std::string::npos && parseCell(cell, '.') ? 1U : 0U;
        }
    }
    return commas > points ? ',' : '.';
}

bool isValue(std::string_view cell, char decimalPoint) {
    return parseCell(cell, decimalPoint) || parseIsoTime(cell);
}

/// Names of columns, rather than values: no cell is one, and some are not empty.
bool looksLikeNames(const Fields& row, char decimalPoint) {
    bool any = false;
    for (const std::string& cell : row) {
        if (isValue(cell, decimalPoint))
            return false;
        any = any || !trimmed(cell).empty();
    }
    return any;
}

/// "s,mm,mm": some known units, and nothing that is a value.
bool looksLikeUnits(const Fields& row, char decimalPoint) {
    std::size_t units = 0, filled = 0;
    for (const std::string& cell : row) {
        if (isValue(cell, decimalPoint))
            return false;
        filled += trimmed(cell).empty() ? 0U : 1U;
        units += unitFromText(cell) ? 1U : 0U;
    }
    return units > 0 && 2 * units >= filled;
}

/// Columns of the session log that hold words, also while the first rows are empty there.
bool isKnownWord(std::string_view name) {
    static constexpr std::array<std::string_view, 7> kWords{"event", "state",   "status", "mode",
                                                            "note",  "comment", "message"};
    return std::find(kWords.begin(), kWords.end(), name) != kWords.end();
}

bool isTimeName(std::string label) {
    std::transform(label.begin(), label.end(), label.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    static constexpr std::array<std::string_view, 9> kNames{
        "time", "t", "timestamp", "datetime", "date", "epoch", "elapsed", "utc", "clock"};
    return std::find(kNames.begin(), kNames.end(), label) != kNames.end();
}

/// What the sampled cells of a column are.
struct CellCount {
    std::size_t filled = 0, numbers = 0, isoTimes = 0;
    double largest = 0.0;
};

CellCount countCells(const std::vector<Fields>& rows, std::size_t column, char decimalPoint) {
    CellCount count;
    for (const Fields& row : rows) {
        if (column >= row.size() || trimmed(row[column]).empty())
            continue;
        ++count.filled;
        if (const auto number = parseCell(row[column], decimalPoint)) {
            ++count.numbers;
            count.largest = std::max(count.largest, std::abs(*number));
        } else if (parseIsoTime(row[column])) {
            ++count.isoTimes;
        }
    }
    return count;
}

CellKind kindOf(const CellCount& count, const ColumnInfo& info) {
    if (isKnownWord(info.name))
        return CellKind::Word;
    if (2 * count.isoTimes > count.filled)
        return CellKind::Time;
    return count.filled == 0 || 2 * count.numbers >= count.filled ? CellKind::Number : CellKind::Word;
}

/// By its unit, else by its size: seconds since 1970 have ten digits before the point, milliseconds thirteen.
TimeText timeTextOf(const ColumnInfo& info, double largest) {
    if (info.unit == "s")
        return TimeText::Seconds;
    if (info.unit == "ms")
        return TimeText::Millis;
    if (info.unit == "us")
        return TimeText::Micros;
    if (info.unit == "ns")
        return TimeText::Nanos;
    return largest >= 1e17   ? TimeText::Nanos
           : largest >= 1e14 ? TimeText::Micros
           : largest >= 1e11 ? TimeText::Millis
                             : TimeText::Seconds;
}

/// Whether times are so large that they count from 1970: after 1973 as seconds.
bool isSince1970(TimeText form, double largest) {
    constexpr double kLeastSeconds = 1e8;
    switch (form) {
    case TimeText::Iso:
        return true;
    case TimeText::Seconds:
        return largest >= kLeastSeconds;
    case TimeText::Millis:
        return largest >= 1e3 * kLeastSeconds;
    case TimeText::Micros:
        return largest >= 1e6 * kLeastSeconds;
    case TimeText::Nanos:
        return largest >= 1e9 * kLeastSeconds;
    }
    return false;
}

class Detector {
public:
    Detector(std::string_view text, bool isWhole, const std::string& sourceName) : m_text(text) {
        m_start = skipComments(text);
        const std::string_view rest = text.substr(m_start.offset);
        if (rest.empty() && m_start.lastComment.empty())
            throw InputError(sourceName, isWhole ? "is empty" : "begins with too much that is no table");
        m_format.separator = findSeparator(rest);
        sample(rest);
    }

    TableFormat detect() {
        m_format.decimalPoint = findDecimalPoint(m_rows, m_format.separator);
        takeHeader();
        for (std::size_t i = 0; i < m_format.columns.size(); ++i)
            judge(i);
        chooseTime();
        return m_format;
    }

private:
    struct Place {
        std::size_t offset;
        long line;
    };

    void sample(std::string_view rest) {
        RecordScanner records(rest, m_format.separator);
        while (m_rows.size() < kSampleRows && records.next()) {
            if (records.isBlank())
                continue;
            m_rows.push_back(records.fields());
            m_texts.emplace_back(records.text());
            m_after.push_back({m_start.offset + records.rest(), m_start.line + records.restLine() - 1});
        }
    }

    /// The names, from the first row, or from the last comment before it, or made.
    void takeHeader() {
        Place first{m_start.offset, m_start.line};
        Fields names;
        const auto useRow = [&] {
            first = m_after.front();
            m_rows.erase(m_rows.begin());
            m_after.erase(m_after.begin());
        };
        if (!m_rows.empty() && looksLikeNames(m_rows.front(), m_format.decimalPoint)) {
            names = m_rows.front();
            m_format.headerText = m_texts.front();
            useRow();
        } else {
            RecordScanner comment(m_start.lastComment, m_format.separator);
            const bool fits = comment.next() &&
                              (m_rows.empty() || comment.fields().size() == m_rows.front().size()) &&
                              looksLikeNames(comment.fields(), m_format.decimalPoint) &&
                              (m_rows.empty() || m_rows.front().size() > 1);
            m_format.hasHeader = fits;
            names = fits ? comment.fields() : Fields(m_rows.empty() ? 1 : m_rows.front().size());
            m_format.headerText = fits ? m_start.lastComment : "";
        }
        Fields units(names.size());
        if (m_format.hasHeader && !m_rows.empty() && m_rows.front().size() == names.size() &&
            looksLikeUnits(m_rows.front(), m_format.decimalPoint)) {
            units = m_rows.front();
            useRow();
        }
        m_format.firstRowOffset = first.offset;
        m_format.firstRowLine = first.line;
        name(names, units);
    }

    /// Each name is made unique.
    void name(const Fields& names, const Fields& units) {
        std::set<std::string> taken;
        for (std::size_t i = 0; i < names.size(); ++i) {
            std::string base(trimmed(names[i]));
            if (base.empty()) {
                base = "column " + std::to_string(i + 1);
                if (m_format.hasHeader)
                    m_format.unnamed.push_back(i);
            }
            std::string unique = base;
            for (int n = 2; !taken.insert(unique).second; ++n)
                unique = base + " (" + std::to_string(n) + ")";
            if (unique != base)
                m_format.renamed.push_back(i);
            LabelAndUnit parts = splitUnit(base);
            if (const auto unit = unitFromText(units[i]))
                parts.unit = *unit;
            else if (!trimmed(units[i]).empty())
                parts.unit = trimmed(units[i]);
            m_format.columns.push_back(
                {unique, parts.label, parts.unit, CellKind::Number, TimeText::Seconds});
        }
    }

    void judge(std::size_t column) {
        ColumnInfo& info = m_format.columns[column];
        m_counts.push_back(countCells(m_rows, column, m_format.decimalPoint));
        info.kind = kindOf(m_counts.back(), info);
        info.timeText = TimeText::Iso;
    }

    /// The first column with a name of time that holds numbers or times; else the first one, if it holds
    /// times.
    void chooseTime() {
        for (std::size_t i = 0; i < m_format.columns.size() && !m_format.timeColumn; ++i)
            if (isTimeName(m_format.columns[i].label) && m_format.columns[i].kind != CellKind::Word)
                m_format.timeColumn = i;
        if (!m_format.timeColumn && !m_format.columns.empty() &&
            m_format.columns.front().kind == CellKind::Time)
            m_format.timeColumn = 0;
        if (!m_format.timeColumn)
            return;
        ColumnInfo& info = m_format.columns[*m_format.timeColumn];
        const double largest = m_counts[*m_format.timeColumn].largest;
        if (info.kind == CellKind::Number)
            info.timeText = timeTextOf(info, largest);
        info.kind = CellKind::Time;
        m_format.timeIsCalendar = isSince1970(info.timeText, largest);
    }

    std::string_view m_text;
    Start m_start;
    std::vector<Fields> m_rows;
    std::vector<std::string> m_texts;
    std::vector<Place> m_after; ///< of the record that follows each row
    std::vector<CellCount> m_counts;
    TableFormat m_format;
};

} // namespace

TableFormat detectFormat(std::string_view beginning, bool isWhole, const std::string& sourceName) {
    return Detector(beginning, isWhole, sourceName).detect();
}

} // namespace hexapose
