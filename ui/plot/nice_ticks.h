// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace hexapose {

/// One axis: its ends, and the distance of its ticks where that is settled (0: as the room allows).
struct AxisRange {
    double low = 0.0;
    double high = 1.0;
    double tick = 0.0;
    bool operator==(const AxisRange&) const = default;
};

/// 1, 2 or 5 times a power of ten, not below `atLeast` (> 0).
double niceStep(double atLeast);

/// The basic range, grown to round numbers when the data leaves it, with its ticks.
AxisRange grownRange(double low, double high, const std::optional<std::pair<double, double>>& data);

/// The data with a margin above and below, wide enough for ticks that can be told apart, whatever the
/// numbers; 0 to 1 without data.
AxisRange roomyRange(const std::optional<std::pair<double, double>>& data);

/// The marks of one axis: round values within the range, labels of equal precision, and the power of ten that
/// was taken out of them.
struct Ticks {
    std::vector<double> values;
    std::vector<QString> labels;
    int exponent = 0; ///< labels times 10^exponent are the values
};

enum class TickLabels {
    PowerOfTen, ///< taken out of very large and very small numbers
    Plain,
    Whole ///< whole numbers only
};

/// At most `most` marks (at least one) in a range low < high of finite numbers.
Ticks niceTicks(double low, double high, int most, TickLabels labels = TickLabels::PowerOfTen);
/// The multiples of the range's own tick, or of a larger round number when they are more than `most`.
Ticks niceTicks(const AxisRange& range, int most, TickLabels labels = TickLabels::PowerOfTen);

/// "×10⁻⁴"; empty for 0.
QString timesPowerOfTen(int exponent);

} // namespace hexapose
