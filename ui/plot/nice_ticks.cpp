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
constexpr int kPlainDigits =
    6; ///< of labels that differ only after so many are plain: a power would add digits
constexpr double kLargestStep = 1e308;
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
    const bool distant = exponent > kPlainExponentMax && exponent - exponentOf(step) >= kPlainDigits &&
                         exponent < 2 * kPlainDigits;
    if (labels == TickLabels::PowerOfTen && !distant &&
        (exponent < kPlainExponentMin || exponent > kPlainExponentMax))
        ticks.exponent = exponent;
    const double power = std::pow(10.0, ticks.exponent);
    const int decimals = std::max(0, -exponentOf(step / power * (1.0 + kRounding)));
    for (const double value : ticks.values)
        ticks.labels.push_back(QString::fromStdString(formatFixed(value / power, decimals)));
}

} // namespace

double niceStep(double atLeast) {
    atLeast = std::min(atLeast, kLargestStep);
    const double power = std::pow(10.0, exponentOf(atLeast));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power * (1.0 + kRounding) >= atLeast)
            return factor * power;
    return 10.0 * power;
}

AxisRange roomyRange(const std::optional<std::pair<double, double>>& data) {
    constexpr double kMargin = 0.05; // of the range, above and below
    constexpr double kLeast = 1e-12; // of the values: a shorter range has no numbers to tell its ticks apart
    constexpr double kLeastEver = 1e-300;
    constexpr double kMost = 1.6e308;
    if (!data)
        return {0.0, 1.0};
    const auto [low, high] = *data;
    const double size = std::max(std::abs(low), std::abs(high));
    const double half = 0.5 * high - 0.5 * low;
    double margin = 2.0 * kMargin * half;
    if (half < kLeast * size || half < kLeastEver)
        margin = half > 0.0 ? std::max(kLeast * size, kLeastEver) : std::max(kMargin * size, kLeastEver);
    if (size == 0.0)
        margin = 1.0;
    return {std::max(low - margin, -kMost), std::min(high + margin, kMost)};
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
    const double room = std::max(1, most);
    const double densest = range.high / room - range.low / room;     // the range itself may be no number
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
