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
constexpr double kTicksWanted = 4.0;
constexpr double kRounding = 1e-9; ///< so that 40.000000001 mm is not taken for more than 40

int exponentOf(double value) {
    return static_cast<int>(std::floor(std::log10(value)));
}

/// The multiples of the step within the range.
std::vector<double> multiples(double step, double low, double high) {
    const double slack = step * 1e-6;
    std::vector<double> values;
    for (double i = std::ceil((low - slack) / step); i * step <= high + slack; i += 1.0)
        values.push_back(i * step);
    return values;
}

/// Labels of equal precision.
void putLabels(Ticks& ticks, double step, TickLabels labels) {
    const double largest = std::max({std::abs(ticks.values.front()), std::abs(ticks.values.back()), step});
    const int exponent = exponentOf(largest * (1.0 + kRounding));
    if (labels == TickLabels::PowerOfTen && (exponent < kPlainExponentMin || exponent > kPlainExponentMax))
        ticks.exponent = exponent;
    const double power = std::pow(10.0, ticks.exponent);
    const int decimals = std::max(0, -exponentOf(step / power * (1.0 + kRounding)));
    for (const double value : ticks.values)
        ticks.labels.push_back(QString::fromStdString(formatFixed(value / power, decimals)));
}

} // namespace

double niceStep(double atLeast) {
    const double power = std::pow(10.0, exponentOf(atLeast));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power * (1.0 + kRounding) >= atLeast)
            return factor * power;
    return 10.0 * power;
}

AxisRange grownRange(double low, double high, const std::optional<std::pair<double, double>>& data) {
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

Ticks niceTicks(double low, double high, int most, TickLabels labels) {
    return niceTicks(AxisRange{low, high}, most, labels);
}

Ticks niceTicks(const AxisRange& range, int most, TickLabels labels) {
    const double densest = (range.high - range.low) / std::max(1, most);
    double unit = range.tick > 0.0 ? range.tick : niceStep(densest); // what the labels have decimals for
    if (labels == TickLabels::Whole)
        unit = std::max(unit, 1.0);
    const double step = unit * std::max(1.0, niceStep(densest / unit));
    Ticks ticks;
    ticks.values = multiples(step, range.low, range.high);
    while (ticks.values.empty()) {   // a coarse step may miss a short range
        unit = niceStep(unit / 2.6); // the next smaller of 1, 2, 5
        ticks.values = multiples(unit, range.low, range.high);
    }
    putLabels(ticks, unit, labels);
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
