// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/csv_table.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// Reads a CSV row by row, for files that do not belong in memory whole. The rules are those of CsvTable.
class CsvReader {
public:
    CsvReader(std::istream& in, std::string sourceName);

    const std::string& sourceName() const { return m_sourceName; }
    const std::vector<std::string>& header() const { return m_header; }
    /// The next row into `row`, whose memory is used again; false at the end.
    bool next(CsvTable::Row& row);
    /// After the end: the half-written last line.
    const std::optional<CsvTable::Row>& halfWritten() const { return m_halfWritten; }
    std::string halfWrittenWarning() const;

private:
    enum class Ending { Nothing, Line, EndOfFile, InsideQuote };

    int peek();
    int take();
    bool atLineEnd();
    void takeLineEnd();
    void skipByteOrderMark();
    Ending readRecord(CsvTable::Row& row);
    bool readQuoted(std::string& field);

    std::istream& m_in;
    std::string m_sourceName;
    std::vector<std::string> m_header;
    std::optional<CsvTable::Row> m_halfWritten;
    std::array<char, 1 << 16> m_buffer{};
    std::size_t m_position = 0;
    std::size_t m_filled = 0;
    long m_line = 1;
};

/// Finding columns in a header, as CsvTable does.
std::optional<std::size_t> findCsvColumn(const std::vector<std::string>& header, std::string_view name);
std::size_t requireCsvColumn(const std::vector<std::string>& header, std::string_view name,
                             const std::string& sourceName);

/// "-" is standard input. Throws InputError when it cannot be opened, or is a directory.
class CsvSource {
public:
    explicit CsvSource(const std::filesystem::path& file);
    std::istream& stream() { return m_file ? *m_file : *m_standardInput; }
    const std::string& name() const { return m_name; }

private:
    std::unique_ptr<std::ifstream> m_file;
    std::istream* m_standardInput = nullptr;
    std::string m_name;
};

} // namespace hexapose
