// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// A CSV with a header row (RFC 4180 quoting, LF or CRLF, a UTF-8 byte order mark allowed; blank lines
/// skipped; blanks around a column's name do not count). A last line without its line end that has too few
/// fields, or ends inside a quote, counts as half-written and is left out with a warning. Elsewhere a row
/// with another number of fields than the header is kept as it is: the caller decides.
struct CsvTable {
    struct Row {
        long line; ///< 1-based line in the file
        std::vector<std::string> fields;
    };
    std::string sourceName;
    std::vector<std::string> header;
    std::vector<Row> rows;
    std::vector<std::string> warnings; ///< "run.csv:812: half-written last line left out"
    std::optional<Row> halfWritten;    ///< that line, for a caller that has to answer every row

    std::optional<std::size_t> findColumn(std::string_view name) const;
    /// Throws InputError "file:1: column l3_mm is missing", or "appears twice".
    std::size_t requireColumn(std::string_view name) const;
    /// The field, or an empty text when the row is too short.
    static std::string_view field(const Row& row, std::size_t column);
};

/// "-" is standard input. Throws InputError for a file that cannot be read, is empty, or has an unterminated
/// quote.
CsvTable readCsv(const std::filesystem::path& file);
CsvTable readCsv(std::istream& in, const std::string& sourceName);

/// Quotes when needed.
std::string csvField(std::string_view text);

} // namespace hexapose
