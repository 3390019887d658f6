// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/nice_ticks.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

/// Plain labels between 0.01 and 9999; outside, a power of ten stands above the axis.
constexpr int kPlainExponentMin = -2;
constexpr int kPlainExponentMax = 3;

int exponentOf(double value) {
    return static_cast<int>(std::floor(std::log10(value)));
}

/// The smallest of 1, 2, 5 times a power of ten that is not below the value.
double niceStep(double atLeast) {
    const double power = std::pow(10.0, exponentOf(atLeast));
    constexpr double kSlack = 1.0 + 1e-9;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power * kSlack >= atLeast)
            return factor * power;
    return 10.0 * power;
}

/// The multiples of the step within the range.
std::vector<double> multiples(double step, double low, double high) {
    const double slack = step * 1e-6;
    std::vector<double> values;
    for (double i = std::ceil((low - slack) / step); i * step <= high + slack; i += 1.0)
        values.push_back(i * step);
    return values;
}

} // namespace

Ticks niceTicks(double low, double high, int most, bool integers) {
    double step = niceStep((high - low) / std::max(1, most));
    if (integers)
        step = std::max(step, 1.0);
    Ticks ticks;
    ticks.values = multiples(step, low, high);
    while (ticks.values.empty()) {   // a coarse step may miss a short range
        step = niceStep(step / 2.6); // the next smaller of 1, 2, 5
        ticks.values = multiples(step, low, high);
    }

    const double largest = std::max({std::abs(ticks.values.front()), std::abs(ticks.values.back()), step});
    const int exponent = exponentOf(largest * (1.0 + 1e-9));
    if (!integers && (exponent < kPlainExponentMin || exponent > kPlainExponentMax))
        ticks.exponent = exponent;
    const double power = std::pow(10.0, ticks.exponent);
    const int decimals = std::max(0, -exponentOf(step / power * (1.0 + 1e-9)));
    for (const double value : ticks.values)
        ticks.labels.push_back(QString::fromStdString(formatFixed(value / power, decimals)));
    return ticks;
}

QString timesPowerOfTen(int exponent) {
    if (exponent == 0)
        return {};
    static const QString superscripts = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = QStringLiteral("×10");
    for (const QChar c : QString::number(exponent))
        text += c == QLatin1Char('-') ? QChar(0x207B) : superscripts[c.digitValue()];
    return text;
}

} // namespace hexapose
