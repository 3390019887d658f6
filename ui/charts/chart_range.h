// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

namespace hexapose {

/// An axis: its ends and the distance of its ticks.
struct AxisRange {
    double low = 0.0;
    double high = 1.0;
    double tick = 0.5;
    bool operator==(const AxisRange&) const = default;
};

/// 1, 2 or 5 times a power of ten, not below `value` (> 0).
double niceStep(double value);

/// The basic range, grown to round numbers when the data leaves it.
AxisRange chartRange(double low, double high, const std::optional<std::pair<double, double>>& data);

/// Decimals that its tick labels need.
int tickDecimals(double tick);

} // namespace hexapose
