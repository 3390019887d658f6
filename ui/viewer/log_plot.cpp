// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/log_plot.h"

#include "core/base/utc_text.h"
#include "ui/viewer/qt_text.h"

#include <array>
#include <chrono>
#include <cmath>
#include <limits>

namespace hexapose {

namespace {

constexpr double kTimeTicks = 8.0;
constexpr double kValueTicks = 4.0;
constexpr std::size_t kColours = 8;

struct ColourPair {
    QRgb light, dark;
};
/// Told apart by most eyes, and dark or light enough for their ground.
constexpr std::array<ColourPair, kColours> kPalette{{{0x0a64c2, 0x4c9ffe},
                                                     {0xc2410c, 0xff9a5c},
                                                     {0x00805f, 0x3ecf9f},
                                                     {0x8e3fa8, 0xd58cf0},
                                                     {0x7a6a00, 0xe0cc4a},
                                                     {0xb8255f, 0xff7fae},
                                                     {0x00788f, 0x4fd0e8},
                                                     {0x5b5f66, 0xb4bcc6}}};

QString unitText(const std::string& unit) {
    return unit == "deg" ? QString::fromUtf8("\u00b0") : toQt(unit);
}

/// "mm"; "mm, %" where the curves differ.
QString unitsOf(const std::vector<Curve>& curves) {
    QStringList units;
    for (const Curve& curve : curves) {
        const QString unit = unitText(curve.column->info().unit);
        if (!unit.isEmpty() && !units.contains(unit))
            units.append(unit);
    }
    return units.join(QStringLiteral(", "));
}

/// In the legend without its unit, where no other curve is called so.
QString legendName(const std::vector<Curve>& curves, std::size_t index) {
    const QString label = toQt(curves[index].column->info().label);
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (i != index && toQt(curves[i].column->info().label) == label)
            return curves[index].spec.name();
    return label.isEmpty() ? curves[index].spec.name() : label;
}

} // namespace

QColor curveColour(std::size_t index, ThemeKind theme) {
    const ColourPair& pair = kPalette[index % kColours];
    return QColor(theme == ThemeKind::Dark ? pair.dark : pair.light);
}

Qt::PenStyle curveLine(std::size_t index) {
    constexpr std::array<Qt::PenStyle, 4> kLines{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    return kLines[(index / kColours) % kLines.size()];
}

std::optional<std::pair<double, double>> valuesIn(const Table& table, const std::vector<Curve>& curves,
                                                  const TimeSpan& view) {
    MinMax all;
    for (const RowRange& rows : table.time().rowsBetween(view.begin, view.end))
        for (const Curve& curve : curves)
            all.add(curve.column->range(rows.begin, rows.end));
    if (all.isEmpty())
        return std::nullopt;
    constexpr double kMost = std::numeric_limits<double>::max(); // an infinity has no place on an axis
    return std::pair(std::max(all.min, -kMost), std::min(all.max, kMost));
}

QString timeTitle(const Table& table) {
    if (!table.time().hasTime())
        return LogPlotWords::tr("Row");
    if (!table.time().isCalendar())
        return LogPlotWords::tr("Time, s");
    const std::chrono::system_clock::time_point origin{
        std::chrono::duration_cast<std::chrono::system_clock::duration>(
            std::chrono::nanoseconds(table.time().originNs()))};
    return LogPlotWords::tr("Time, s after %1").arg(toQt(formatUtc(origin)));
}

Plot emptyLogPlot(const LogPlotSource& source, const TimeSpan& view, const std::optional<AxisRange>& values) {
    const std::vector<Curve>& curves = source.curves;
    Plot plot;
    plot.title = source.chart.title();
    plot.xLabel = timeTitle(*source.table);
    plot.yLabel = unitsOf(curves);
    plot.x = {view.begin, view.end, niceStep(view.length() / kTimeTicks)};
    plot.y = values ? *values : roomyRange(valuesIn(*source.table, curves, view));
    plot.y.tick = niceStep(plot.y.high / kValueTicks - plot.y.low / kValueTicks);
    if (curves.empty() && !source.chart.curves.empty() && source.table->rowCount() > 0)
        plot.note = LogPlotWords::tr("This log has none of these columns");
    return plot;
}

void fillLogPlot(Plot& plot, const LogPlotSource& source, const TimeSpan& view, int pixels) {
    const Table& table = *source.table;
    const std::vector<Curve>& curves = source.curves;
    plot.series.clear();
    for (std::size_t i = 0; i < curves.size(); ++i) {
        Plot::Series series;
        series.name = legendName(curves, i);
        series.colour = curveColour(i, source.theme);
        series.line = curveLine(i);
        series.marker = Plot::Marker::None;
        series.isReduced = true;
        series.points =
            pointsOf(reduceToPixels(*curves[i].column, table.time(), {view.begin, view.end, pixels}));
        plot.series.push_back(std::move(series));
    }
    if (source.marks != nullptr) {
        plot.spans = source.marks->spans(table, view, pixels, source.colors);
        plot.instants = source.marks->instants(table, view, pixels);
    }
}

std::vector<QPointF> pointsOf(const std::vector<PixelColumn>& columns) {
    std::vector<QPointF> points;
    points.reserve(columns.size() * 4);
    double before = std::numeric_limits<double>::quiet_NaN();
    for (const PixelColumn& column : columns) {
        // A row without a time stands where the one before it does.
        const double first = std::isnan(column.firstTime) ? before : column.firstTime;
        const double last = std::isnan(column.lastTime) ? first : column.lastTime;
        if (std::isnan(first))
            continue;
        before = last;
        if (column.gapBefore && !points.empty())
            points.emplace_back(first, std::numeric_limits<double>::quiet_NaN());
        points.emplace_back(first, column.first);
        if (first == last && column.min == column.max)
            continue;
        // Between first and last, so that the shorter way is drawn.
        const double middle = 0.5 * (first + last);
        const bool isRising = column.last >= column.first;
        points.emplace_back(middle, isRising ? column.min : column.max);
        points.emplace_back(middle, isRising ? column.max : column.min);
        points.emplace_back(last, column.last);
    }
    return points;
}

} // namespace hexapose
