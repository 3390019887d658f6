// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace hexapose {

/// The marks of one axis: round values within the range, labels of equal precision, and the power of ten that
/// was taken out of them.
struct Ticks {
    std::vector<double> values;
    std::vector<QString> labels;
    int exponent = 0; ///< labels times 10^exponent are the values
};

/// At most `most` marks (at least one) in a range low < high of finite numbers. Whole numbers only, when
/// asked for.
Ticks niceTicks(double low, double high, int most, bool integers = false);

/// "×10⁻⁴"; empty for 0.
QString timesPowerOfTen(int exponent);

} // namespace hexapose
