// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/column.h"

#include <string>
#include <vector>

namespace hexapose {

/// The statistics of some rows of a column, as text: numbers in the column's own unit, times in the form of
/// the file and exact, words as they are. Empty where there is nothing to say.
struct ColumnSummary {
    std::size_t count = 0;   ///< cells with a value
    std::size_t missing = 0; ///< without
    std::string min, max, mean, sigma, rms, first, last;
};

ColumnSummary summarize(const Column& column, const std::vector<RowRange>& rows);

/// A time as its column has it: exact, in decimals of its unit, or as ISO 8601 in UTC.
std::string timeText(std::int64_t nanoseconds, TimeText form);

} // namespace hexapose
