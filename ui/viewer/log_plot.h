// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/reduction.h"
#include "ui/plot/plot.h"
#include "ui/viewer/curve_finder.h"
#include "ui/viewer/table_marks.h"

#include <optional>
#include <vector>

namespace hexapose {

/// A chart of a log on its way to the screen or to paper.
struct LogPlotSource {
    std::shared_ptr<const Table> table;
    const TableMarks* marks = nullptr; ///< null: none are drawn
    ChartSpec chart;
    std::vector<Curve> curves; ///< of the chart, those that the table has
    ThemeColors colors;
    ThemeKind theme = ThemeKind::Light;
};

/// Smallest and largest value that a view shows; nothing where there is none.
std::optional<std::pair<double, double>> valuesIn(const Table& table, const std::vector<Curve>& curves,
                                                  const TimeSpan& view);

/// Frame, axes and title for a view, without the curves: what the place for them depends on. Its y axis has
/// room for the values of the view where no other is asked for.
Plot emptyLogPlot(const LogPlotSource& source, const TimeSpan& view, const std::optional<AxisRange>& values);
/// The curves and marks, reduced to the pixels of the frame.
void fillLogPlot(Plot& plot, const LogPlotSource& source, const TimeSpan& view, int pixels);

/// The points of a curve: all that shows of it in so many pixels; a NaN is a gap.
std::vector<QPointF> pointsOf(const std::vector<PixelColumn>& columns);

/// How the curve of that place in its chart is drawn.
QColor curveColour(std::size_t index, ThemeKind theme);
Qt::PenStyle curveLine(std::size_t index);

/// For the texts of plots.
struct LogPlotWords {
    Q_DECLARE_TR_FUNCTIONS(LogPlotWords)
};

/// "Time, s", with the date of its zero where the file has dates; "Row" where it has no time.
QString timeTitle(const Table& table);

} // namespace hexapose
