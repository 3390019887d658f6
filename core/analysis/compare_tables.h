// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/table.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// Number columns of the same name and unit in two tables.
struct CommonColumn {
    std::size_t a = 0, b = 0;
};
std::vector<CommonColumn> commonColumns(const Table& a, const Table& b);

/// The value of a column at a time, between its rows along a line; NaN where a cell beside it is missing, in
/// a pause of more than 5 usual steps, and outside.
double valueAt(const Table& table, std::size_t column, double seconds);

/// The time of the first row whose word in the column `event` holds this text.
std::optional<double> timeOfEvent(const Table& table, std::string_view text);

/// The time shift that makes two logs alike: what happens at t in `a` happens at t + shift in `b`. That of
/// the least sum of squared differences of the common columns, each relative to its variance, over an overlap
/// of at least half of the shorter log. Nothing where they have no column in common that changes.
std::optional<double> findShift(const Table& a, const Table& b, const std::vector<CommonColumn>& columns);

/// How a column of `b`, shifted, differs from that of `a`, at the rows of `a`.
struct ColumnDifference {
    std::size_t count = 0; ///< rows that both have a value for
    double rms = 0.0, largest = 0.0;
    double largestAt = 0.0; ///< s, in `a`
};
ColumnDifference compareColumn(const Table& a, const Table& b, CommonColumn column, double shift);

} // namespace hexapose
