// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/csv_table.h"

#include "core/base/csv_reader.h"
#include "core/base/input_error.h"

#include <algorithm>
#include <utility>

namespace hexapose {

std::optional<std::size_t> CsvTable::findColumn(std::string_view name) const {
    return findCsvColumn(header, name);
}

std::size_t CsvTable::requireColumn(std::string_view name) const {
    return requireCsvColumn(header, name, sourceName);
}

std::string_view CsvTable::field(const Row& row, std::size_t column) {
    return column < row.fields.size() ? std::string_view(row.fields[column]) : std::string_view();
}

CsvTable readCsv(const std::filesystem::path& file) {
    CsvSource source(file);
    return readCsv(source.stream(), source.name());
}

CsvTable readCsv(std::istream& in, const std::string& sourceName) {
    CsvReader reader(in, sourceName);
    CsvTable table;
    table.sourceName = sourceName;
    table.header = reader.header();
    for (CsvTable::Row row; reader.next(row);)
        table.rows.push_back(std::move(row));
    table.halfWritten = reader.halfWritten();
    if (table.halfWritten)
        table.warnings.push_back(reader.halfWrittenWarning());
    return table;
}

std::optional<std::size_t> findCsvColumn(const std::vector<std::string>& header, std::string_view name) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - header.begin());
}

std::size_t requireCsvColumn(const std::vector<std::string>& header, std::string_view name,
                             const std::string& sourceName) {
    using Kind = InputFault::Kind;
    const std::vector<std::string> column{std::string(name)};
    switch (std::count(header.begin(), header.end(), name)) {
    case 0:
        if (header.size() == 1 && header.front().find_first_of(";\t") != std::string::npos)
            throw InputError(InputFault{Kind::NoCommas, sourceName, 1, column});
        throw InputError(InputFault{Kind::ColumnMissing, sourceName, 1, column});
    case 1:
        return *findCsvColumn(header, name);
    default:
        throw InputError(InputFault{Kind::ColumnTwice, sourceName, 1, column});
    }
}

std::string csvField(std::string_view text) {
    const bool blankEnds = !text.empty() && (text.front() == ' ' || text.back() == ' ');
    if (!blankEnds && text.find_first_of(",\"\r\n") == std::string_view::npos)
        return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"')
            quoted += '"';
        quoted += c;
    }
    return quoted += '"';
}

} // namespace hexapose
