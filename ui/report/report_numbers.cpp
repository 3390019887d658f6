// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_numbers.h"

#include "core/base/number_text.h"
#include "core/base/units.h"

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

/// A column of the report takes no more; what is longer is written with an exponent.
constexpr qsizetype kMostCharacters = 11;

QString scientific(double value, int decimals) {
    std::array<char, 48> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::scientific, decimals)
                         .ptr;
    const QString text = QString::fromLatin1(buffer.data(), end - buffer.data());
    const auto e = text.indexOf(QLatin1Char('e'));
    return text.left(e + 1) + QString::number(text.mid(e + 1).toInt()); // e-04 becomes e-4
}

/// A whole column changes to exponents together, but for the odd value that does not fit.
QString fixed(double value, int decimals, int mostDecimals, int digitsWithExponent) {
    if (!std::isfinite(value))
        return kUnknown;
    const QString text = QString::fromStdString(formatFixed(value, decimals));
    const bool fits = decimals <= mostDecimals && text.size() <= kMostCharacters;
    return fits ? text : value == 0.0 ? QStringLiteral("0") : scientific(value, digitsWithExponent - 1);
}

constexpr int kMostValueDecimals = 8;
constexpr int kMostErrorDecimals = 6;
constexpr int kErrorDigits = 3;
constexpr int kValueDigits = 6;

} // namespace

QString errorText(double value) {
    if (!std::isfinite(value))
        return std::isinf(value) ? QStringLiteral("∞") : kUnknown;
    if (value == 0.0)
        return QStringLiteral("0");
    return scientific(value, kErrorDigits - 1);
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
    return fixed(value, coordinate < 3 ? m_metres : m_radians, kMostValueDecimals, kValueDigits);
}

QString PoseDecimals::common(int coordinate, double value) const {
    return fixed(commonUnits(coordinate, value), coordinate < 3 ? m_mm : m_degrees, kMostValueDecimals,
                 kValueDigits);
}

QString PoseDecimals::commonError(int coordinate, double value) const {
    const double shown = commonUnits(coordinate, value);
    const int decimals = (coordinate < 3 ? m_mm : m_degrees) + 1;
    const bool vanishes = shown != 0.0 && std::abs(shown) < std::pow(10.0, -decimals);
    return vanishes || std::isinf(shown) ? errorText(shown)
                                         : fixed(shown, decimals, kMostErrorDecimals, kErrorDigits);
}

double commonUnits(int coordinate, double value) {
    return coordinate < 3 ? mmFromMetres(value) : degFromRadians(value);
}

} // namespace hexapose
