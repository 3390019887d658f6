// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/row_parser.h"
#include "core/table/table.h"

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hexapose {

/// Appends parsed blocks to a table. For each block begin() reserves its rows, in the order of the blocks;
/// copy() fills them, beside all else; complete() takes them into the table, when those before are there.
/// All but copy() by one thread at a time.
class TableBuilder {
public:
    /// huge: the table will be large.
    TableBuilder(const TableFormat& format, std::string sourceName, bool huge);

    /// A block's place.
    struct Reserved {
        struct Target {
            std::vector<void*> chunks;        ///< of the first row's chunk, and the next ones
            std::vector<std::uint32_t> codes; ///< of the block's words in the table, from its code 1
        };
        std::size_t block = 0; ///< 0, 1 ...
        Row firstRow = 0;
        std::size_t rowCount = 0;
        std::vector<Target> columns;
        std::vector<ParsedRows::Place> places;
        std::vector<Problem> problems;
        std::uint64_t rowsLeftOut = 0, cellsMissing = 0, problemCount = 0;
    };
    Reserved begin(const ParsedRows& rows);
    static void copy(const ParsedRows& rows, const Reserved& reserved, const TableFormat& format);
    void complete(Reserved reserved);
    /// Of the file as a whole.
    void report(Problem problem) { add(std::move(problem)); }

    /// What is complete by now.
    std::shared_ptr<const Table> table() const { return std::make_shared<const Table>(m_table); }
    Row rowCount() const { return m_table.m_rowCount; }

private:
    void append(const Reserved& block);
    void followTime(Row begin, Row end);
    void add(Problem problem);

    Table m_table;
    std::vector<std::unordered_map<std::string, std::uint32_t>> m_wordCodes;
    TableFormat m_format;
    bool m_huge;
    std::size_t m_begun = 0, m_appended = 0; ///< blocks
    Row m_reserved = 0;
    long m_nextLine;                           ///< of the block that begin() takes next
    std::map<std::size_t, Reserved> m_waiting; ///< blocks that are complete before an earlier one
    std::int64_t m_lastTime = kNoTime;
    std::int64_t m_earliest = kNoTime, m_latest = kNoTime;
    std::vector<std::int64_t> m_steps; ///< the first ones, for the usual one
};

} // namespace hexapose
