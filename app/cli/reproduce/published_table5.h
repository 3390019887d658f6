// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

/// The physical test of Applied Sciences 2023, 13, 3082 (section 3.3, Figure 7, Table 5), as printed.
namespace hexapose::published {

/// Lengths read from the drives, mm, one decimal.
inline constexpr std::array<double, 6> kTable5LengthsMm{339.5, 336.5, 336.6, 329.2, 345.1, 334.5};

struct Table5Row {
    const char* coordinate;
    const char* unit;
    int index;        ///< in the pose vector x y z alpha beta gamma
    double reference; ///< what the operator set: 0 0 5 deg, 12 -4 40 mm
    double solved;    ///< the pose that the paper prints
    double lastDigit; ///< one unit of its last printed digit
    double corrected; ///< what it must have been; differs from `solved` only for gamma
};

/// gamma: 0.0896 is 0.0869 with two digits exchanged; no solution of these lengths gives it, and every other
/// entry of the table agrees with the solution whose gamma is 0.0869. Its reference, 5 deg, is 0.08727 rad,
/// printed as 0.0870.
inline constexpr std::array<Table5Row, 6> kTable5{{
    {"alpha", "rad", 3, 0.0, -1.68e-4, 1e-6, -1.68e-4},
    {"beta", "rad", 4, 0.0, 5.83e-5, 1e-7, 5.83e-5},
    {"gamma", "rad", 5, 0.0870, 0.0896, 1e-4, 0.0869},
    {"x", "m", 0, 0.012, 0.0120, 1e-4, 0.0120},
    {"y", "m", 1, -0.004, -0.0040, 1e-4, -0.0040},
    {"z", "m", 2, 0.040, 0.0398, 1e-4, 0.0398},
}};

} // namespace hexapose::published
