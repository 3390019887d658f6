// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_numbers.h"

#include "core/geometry/number_text.h"
#include "core/geometry/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace hexapose {

namespace {

const QString kUnknown = QStringLiteral("–");

int decimalsFor(double bound, int otherwise) {
    if (!(bound > 0.0) || !std::isfinite(bound))
        return otherwise;
    constexpr int kMost = 12;
    return std::clamp(static_cast<int>(std::ceil(-std::log10(bound))) + 2, 0, kMost);
}

QString fixed(double value, int decimals) {
    constexpr double kTooWideForItsColumn = 1e7;
    if (!std::isfinite(value))
        return kUnknown;
    return std::abs(value) < kTooWideForItsColumn ? QString::fromStdString(formatFixed(value, decimals))
                                                  : errorText(value);
}

} // namespace

QString errorText(double value) {
    if (!std::isfinite(value))
        return std::isinf(value) ? QStringLiteral("∞") : kUnknown;
    if (value == 0.0)
        return QStringLiteral("0");
    std::array<char, 32> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific, 2)
            .ptr;
    const QString text = QString::fromLatin1(buffer.data(), end - buffer.data());
    const auto e = text.indexOf(QLatin1Char('e'));
    return text.left(e + 1) + QString::number(text.mid(e + 1).toInt()); // e-04 becomes e-4
}

PoseDecimals::PoseDecimals(const ErrorReport& report) {
    const PoseVector bound = largestPredictedBound(report);
    const double metres = bound.head<3>().maxCoeff();
    const double radians = bound.tail<3>().maxCoeff();
    m_metres = decimalsFor(metres, 6);
    m_radians = decimalsFor(radians, 6);
    m_mm = decimalsFor(mmFromMetres(metres), 3);
    m_degrees = decimalsFor(degFromRadians(radians), 4);
}

QString PoseDecimals::si(int coordinate, double value) const {
    return fixed(value, coordinate < 3 ? m_metres : m_radians);
}

QString PoseDecimals::common(int coordinate, double value) const {
    return fixed(commonUnits(coordinate, value), coordinate < 3 ? m_mm : m_degrees);
}

double commonUnits(int coordinate, double value) {
    return coordinate < 3 ? mmFromMetres(value) : degFromRadians(value);
}

} // namespace hexapose
