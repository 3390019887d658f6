// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/column.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// How a CSV file is written.
struct TableFormat {
    char separator = ',';
    char decimalPoint = '.';
    bool hasHeader = true;
    std::string headerText; ///< as the file has it
    std::vector<ColumnInfo> columns;
    std::optional<std::size_t> timeColumn; ///< empty: the number of the row
    bool timeIsCalendar = false;           ///< times are since 1970, UTC
    std::uint64_t firstRowOffset = 0;      ///< in bytes of the text
    long firstRowLine = 1;
    std::vector<std::size_t> renamed, unnamed; ///< columns whose name had to be changed, or made
};

/// Finds out how a file is written from its beginning, whole lines of it, up to the end of the file where
/// `isWhole`. Throws InputError for one that is empty.
TableFormat detectFormat(std::string_view beginning, bool isWhole, const std::string& sourceName);

} // namespace hexapose
