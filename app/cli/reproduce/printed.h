// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/published_tables.h"

#include <array>
#include <string>
#include <vector>

namespace hexapose::reproduce {

/// The coordinates as the paper orders them.
struct Coordinate {
    const char* name;
    const char* unit;
    int index; ///< in the pose vector x y z alpha beta gamma
};
inline constexpr std::array<Coordinate, 6> kCoordinates{{{"alpha", "rad", 3},
                                                         {"beta", "rad", 4},
                                                         {"gamma", "rad", 5},
                                                         {"x", "m", 0},
                                                         {"y", "m", 1},
                                                         {"z", "m", 2}}};

/// A number as it stands on paper: digits, with a power of ten after them.
struct Printed {
    double value;
    double lastDigit; ///< one unit of it
    int decimals;     ///< of the digits
};
Printed printed(const char* digits, int exponent);

const char* title(published::Algorithm algorithm);
/// "MPR3-NR, set 2".
std::string title(const published::ErrorRow& row);

/// So many digits at most, and no trailing zeros.
std::string inDigits(double value, int digits);
/// "7.00e-4".
std::string threeDigits(double value);
/// "+12.3 %", in so many decimals; "" where the published value is 0.
std::string deviationText(double measured, double published, int decimals);

/// Fields without commas or quotes as a line of CSV.
std::string csvLine(const std::vector<std::string>& fields);

} // namespace hexapose::reproduce
