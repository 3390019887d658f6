// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart_range.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {
constexpr double kTicksWanted = 4.0;
constexpr double kRounding = 1e-9; // so that 40.000000001 mm is not taken for more than 40
} // namespace

double niceStep(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= value * (1.0 - kRounding)) {
            return factor * decade;
        }
    }
    return 10.0 * decade;
}

AxisRange chartRange(double low, double high, const std::optional<std::pair<double, double>>& data) {
    double from = low;
    double to = high;
    if (data) {
        from = std::min(from, data->first);
        to = std::max(to, data->second);
    }
    const double tick = niceStep((to - from) / kTicksWanted);
    if (from < low || to > high) {
        from = std::floor(from / tick + kRounding) * tick;
        to = std::ceil(to / tick - kRounding) * tick;
    }
    return {from, to, tick};
}

int tickDecimals(double tick) {
    return std::clamp(static_cast<int>(std::ceil(-std::log10(tick) - kRounding)), 0, 6);
}

} // namespace hexapose
