// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/styles.h"

#include <algorithm>
#include <cmath>

namespace hexapose::reproduce {

Plot::Series seriesOf(Kind kind, bool connected) {
    switch (kind) {
    case Kind::Published:
        return {QStringLiteral("published"), kBlack, Plot::Marker::Ring, false, {}};
    case Kind::Measured:
        return {
            QStringLiteral("measured, iteration as published"), kBlue, Plot::Marker::Circle, connected, {}};
    case Kind::Exact:
        break;
    }
    return {QStringLiteral("measured, exact Jacobian"), kVermilion, Plot::Marker::Triangle, connected, {}};
}

AxisRange rangeOf(const std::vector<Plot::Series>& series, double headroom) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Plot::Series& one : series)
        for (const QPointF& point : one.points)
            if (std::isfinite(point.y())) {
                low = std::min(low, point.y());
                high = std::max(high, point.y());
            }
    const double more = std::max(headroom * (high - low), 1e-12 * std::max(std::abs(low), std::abs(high)));
    return low <= high && more > 0.0 ? AxisRange{low - more, high + more} : AxisRange{-1.0, 1.0};
}

} // namespace hexapose::reproduce
