// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/line_blocks.h"
#include "core/table/problem.h"
#include "core/table/table_format.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hexapose {

/// The rows of a block of text, column by column. Lines are counted from the block's first, which is 0.
struct ParsedRows {
    struct Cells {
        std::vector<double> numbers;
        std::vector<std::int64_t> times;
        std::vector<std::uint32_t> codes; ///< into `words`, from 1; 0 is the empty word
        std::vector<std::string> words;   ///< those of this block, in the order in which they came
    };
    struct Place {
        std::size_t row;
        long line;
        std::uint64_t offset; ///< in the text
    };
    std::vector<Cells> columns;
    std::size_t rowCount = 0;
    std::vector<Place> places; ///< of the first row, and of each that does not stand on the line after
    std::vector<Problem> problems;
    std::uint64_t rowsLeftOut = 0, cellsMissing = 0, problemCount = 0;
    long lineCount = 0;
};

/// Parses blocks of rows of one format. One for each thread: it uses its memory again.
class RowParser {
public:
    explicit RowParser(const TableFormat& format);
    /// Good until the next call.
    const ParsedRows& parse(const LineBlock& block);

private:
    struct Words {
        std::unordered_map<std::string, std::uint32_t> codes;
        std::string last;
        std::uint32_t lastCode = 0;
    };

    void makeRoom(std::size_t bytes);
    const char* parseRow(const char* begin, const char* end);
    void take(std::size_t column, std::string_view cell);
    void takeWord(std::size_t column, std::string_view cell);
    void doubtLastCell(const char* begin, const char* end);
    void leaveOut(Problem::Kind kind, std::size_t count);
    void report(Problem problem);
    const char* skipEnd(const char* at, const char* end);

    TableFormat m_format;
    ParsedRows m_rows;
    std::vector<Words> m_words;
    std::string m_unquoted;
    const char* m_text = nullptr;
    std::uint64_t m_offset = 0;
    long m_line = 0; ///< of the row that is parsed
    bool m_isLast = false;
};

} // namespace hexapose
