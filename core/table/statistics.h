// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/column.h"

#include <limits>
#include <vector>

namespace hexapose {

/// Of the numbers of some rows of a column; NaN where there are too few.
struct Statistics {
    std::size_t count = 0;   ///< cells with a number
    std::size_t missing = 0; ///< without
    double min = std::numeric_limits<double>::quiet_NaN(), max = min;
    double mean = min;
    double sigma = min; ///< of the sample: over count - 1
    double rms = min;   ///< root of the mean square
    double first = min, last = min;
};

/// Of some rows, in this order. Sums are taken relative to the mean, pairwise: 1e6 with steps of 1e-6 keeps
/// its sigma.
Statistics statisticsOf(const Column& column, const std::vector<RowRange>& rows);
inline Statistics statisticsOf(const Column& column, Row begin, Row end) {
    return statisticsOf(column, {{begin, end}});
}

} // namespace hexapose
