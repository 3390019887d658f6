// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/plot_layout.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kLinesPerTick = 2.2;      ///< where the ticks follow the room
constexpr double kLinesPerFixedTick = 1.2; ///< where they are settled, and only overlap is to be avoided

Ticks yTicksFor(const AxisRange& range, double height, double line) {
    const double lines = range.tick > 0.0 ? kLinesPerFixedTick : kLinesPerTick;
    return niceTicks(range, std::max(2, static_cast<int>(height / (lines * line))));
}

Ticks xTicksFor(const Plot& plot, double width, double gap, const QFontMetricsF& metrics) {
    Ticks ticks;
    for (const Plot::Mark& mark : plot.xMarks) {
        ticks.values.push_back(mark.x);
        ticks.labels.push_back(mark.label);
    }
    if (!ticks.values.empty())
        return ticks;
    const bool whole = !(plot.x.tick > 0.0);
    const int decimals = whole ? 0 : std::max(0, static_cast<int>(std::ceil(-std::log10(plot.x.tick))));
    const double label =
        metrics.horizontalAdvance(QString::number(plot.x.high, 'f', decimals)) + (whole ? 3.0 : 2.0) * gap;
    return niceTicks(plot.x, std::max(2, static_cast<int>(width / label)),
                     whole ? TickLabels::Whole : TickLabels::Plain);
}

} // namespace

QPointF PlotScale::at(double valueX, double valueY) const {
    const double right = (valueX - x.low) / (x.high - x.low);
    // Halved, as the difference of two of the largest numbers is none.
    const double up = (0.5 * valueY - 0.5 * y.low) / (0.5 * y.high - 0.5 * y.low);
    return {frame.left() + right * frame.width(), frame.bottom() - up * frame.height()};
}

double PlotScale::xAt(double position) const {
    return x.low + (position - frame.left()) / frame.width() * (x.high - x.low);
}

double PlotScale::yAt(double position) const {
    const double up = (frame.bottom() - position) / frame.height();
    return (1.0 - up) * y.low + up * y.high;
}

PlotLayout layOutPlot(const Plot& plot, const QRectF& area, const PlotStyle& style,
                      const QPaintDevice& device) {
    const QFontMetricsF text(style.font, &device);
    const QFontMetricsF ticks(style.tickFont, &device);
    const QFontMetricsF title(style.titleFont, &device);
    const double gap = kPlotGap * style.unit;
    const double top = std::max(text.height(), title.height()) + 1.5 * gap;
    const double bottom = ticks.height() + 2.0 * gap + (plot.xLabel.isEmpty() ? 0.0 : text.height());
    const double height = std::max(1.0, area.height() - top - bottom);

    PlotLayout layout;
    layout.yTicks = yTicksFor(plot.y, height, ticks.height());
    double labels = ticks.horizontalAdvance(style.labelRoom);
    for (const QString& label : layout.yTicks.labels)
        labels = std::max(labels, ticks.horizontalAdvance(label));
    const double left = std::max(plot.leastLeft, text.height() + labels + 3.0 * gap);
    const double width = std::max(1.0, area.width() - left - 2.0 * gap);
    layout.xTicks = xTicksFor(plot, width, gap, ticks);

    const QRectF frame(area.left() + left, area.top() + top, width, height);
    layout.scale = {QRectF(QPointF(style.onPixel(frame.left()), style.onPixel(frame.top())),
                           QPointF(style.onPixel(frame.right()), style.onPixel(frame.bottom()))),
                    plot.x, plot.y};
    return layout;
}

} // namespace hexapose
