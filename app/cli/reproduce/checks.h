// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/measurements.h"

#include <string>
#include <vector>

namespace hexapose::reproduce {

/// One measured value beside what it is expected to be.
struct Check {
    std::string what;
    double expected;
    double measured;
    double allowed; ///< of the difference

    bool holds() const; ///< NaN does not
    /// "Newton, set 2, iterations: 45000, expected 41664 within 1250".
    std::string text() const;
};

/// Every error of Table 2: within 25 %, or half a unit of its last printed digit.
std::vector<Check> errorChecks(const std::vector<ErrorMeasurement>& table2);
/// The totals of Table 3: within 3 % for Newton, 10 % for MPR-NR; 0 where 0 is printed.
std::vector<Check> iterationChecks(const std::vector<ErrorMeasurement>& table3);
/// The slope of Table 4, and what the exact Jacobian takes at the finest stop test: within the same parts.
std::vector<Check> stopChecks(const std::vector<StopMeasurement>& table4);

std::size_t holding(const std::vector<Check>& checks);

} // namespace hexapose::reproduce
