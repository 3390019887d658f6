// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/row_text.h"

#include "core/base/input_error.h"
#include "core/table/text_source.h"

#include <algorithm>
#include <fstream>
#include <vector>

namespace hexapose {

namespace {

constexpr std::size_t kBlock = std::size_t{1} << 20;
constexpr std::size_t kLongestShown = 600;

/// The text of a file from a place on. A compressed or UTF-16 one is read from its beginning.
class TextFrom {
public:
    TextFrom(const std::filesystem::path& file, std::uint64_t offset) : m_source(file), m_buffer(kBlock) {
        if (m_source.isPlain()) {
            m_plain.open(file, std::ios::binary);
            m_plain.seekg(static_cast<std::streamoff>(m_source.textBegin() + offset));
            return;
        }
        for (std::uint64_t left = offset; left > 0;) {
            const std::size_t count = m_source.read(
                {m_buffer.data(), static_cast<std::size_t>(std::min<std::uint64_t>(left, kBlock))});
            if (count == 0)
                throw InputError(m_source.name(), "has become shorter");
            left -= count;
        }
    }

    /// At most so many further bytes; none at the end.
    std::string_view next(std::uint64_t most) {
        const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(most, kBlock));
        if (!m_source.isPlain())
            return {m_buffer.data(), m_source.read({m_buffer.data(), wanted})};
        m_plain.read(m_buffer.data(), static_cast<std::streamsize>(wanted));
        return {m_buffer.data(), static_cast<std::size_t>(m_plain.gcount())};
    }

private:
    TextSource m_source;
    std::ifstream m_plain;
    std::vector<char> m_buffer;
};

/// The last row at or before a line.
Row rowBefore(const Table& table, long line) {
    Row low = 0, high = table.rowCount();
    while (low + 1 < high) {
        const Row middle = low + (high - low) / 2;
        (table.lineOf(middle) <= line ? low : high) = middle;
    }
    return low;
}

/// Where lines end: LF, CR LF or CR.
class LineEnds {
public:
    /// Whether this letter is the first of a line.
    bool begins(char letter) {
        const bool isFirst = m_last == '\n' || (m_last == '\r' && letter != '\n');
        m_last = letter;
        return isFirst;
    }

private:
    char m_last = 0;
};

/// Where a row begins.
std::uint64_t offsetOf(const std::filesystem::path& file, const Table& table, Row row) {
    const Table::RowPlace place = table.placeBefore(row);
    Row left = row - place.row;
    std::uint64_t offset = place.offset;
    if (left == 0)
        return offset;
    TextFrom text(file, offset);
    LineEnds ends;
    for (std::string_view block = text.next(kBlock); !block.empty(); block = text.next(kBlock))
        for (const char letter : block) {
            if (ends.begins(letter) && --left == 0)
                return offset;
            ++offset;
        }
    throw InputError(table.sourceName(), "has become shorter");
}

/// Up to and with the end of the line that begins here; a quoted field may hold line ends.
std::string recordFrom(TextFrom& text) {
    std::string record;
    bool isQuoted = false;
    for (std::string_view block = text.next(kBlock); !block.empty(); block = text.next(kBlock))
        for (const char letter : block) {
            if (!record.empty() && record.back() == '\r' && !isQuoted)
                return letter == '\n' ? record + '\n' : record;
            record += letter;
            if (letter == '"')
                isQuoted = !isQuoted;
            if (letter == '\n' && !isQuoted)
                return record;
        }
    return record;
}

void copyBytes(TextFrom& text, std::uint64_t count, const std::function<void(std::string_view)>& write,
               const Table& table) {
    while (count > 0) {
        const std::string_view block = text.next(count);
        if (block.empty())
            throw InputError(table.sourceName(), "has become shorter");
        write(block);
        count -= block.size();
    }
}

} // namespace

std::string textOfLine(const std::filesystem::path& file, const Table& table, long line) {
    long at = 1;
    std::uint64_t offset = 0;
    if (table.rowCount() > 0 && table.lineOf(0) <= line) {
        const Table::RowPlace place = table.placeBefore(rowBefore(table, line));
        at = place.line;
        offset = place.offset;
    }
    TextFrom text(file, offset);
    LineEnds ends;
    std::string shown;
    for (std::string_view block = text.next(kBlock); !block.empty(); block = text.next(kBlock))
        for (const char letter : block) {
            if (ends.begins(letter) && ++at > line)
                return shown;
            if (at == line && letter != '\n' && letter != '\r')
                shown += letter;
            if (shown.size() >= kLongestShown)
                return shown + "...";
        }
    return shown;
}

void copyRows(const std::filesystem::path& file, const Table& table, const TimeSpan& span,
              const std::function<void(std::string_view)>& write) {
    if (!table.headerText().empty())
        write(table.headerText() + "\n");
    for (const auto& [begin, end] : table.time().rowsBetween(span.begin, span.end)) {
        if (begin >= end)
            continue;
        const std::uint64_t first = offsetOf(file, table, begin), last = offsetOf(file, table, end - 1);
        TextFrom text(file, first);
        copyBytes(text, last - first, write, table);
        std::string record = recordFrom(text);
        if (!record.empty() && record.back() != '\n' && record.back() != '\r')
            record += '\n'; // the last line of a file may lack it
        write(record);
    }
}

} // namespace hexapose
