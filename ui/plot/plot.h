// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/nice_ticks.h"
#include "ui/plot/plot_style.h"

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

namespace hexapose {

/// A diagram, on the screen, for print and for files: what it shows. How it looks there is a PlotStyle.
struct Plot {
    /// Told apart by shape as well as by colour.
    enum class Marker { Circle, Square, Triangle, Cross, Ring, None };
    struct Series {
        QString name; ///< empty: not in the legend
        QColor colour;
        Marker marker = Marker::Circle;
        bool connected = true;
        std::vector<QPointF> points; ///< a y that is not finite is a gap
        Qt::PenStyle line = Qt::SolidLine;
        bool isReduced = false; ///< to the pixels of the device, with all that shows there: drawn as it is
    };
    /// Shaded steps of width 1 around whole x, from -y to y; unbounded where y is infinite.
    struct Band {
        QString name;
        QColor colour;
        std::vector<QPointF> steps;
    };
    struct Mark {
        double x;
        QString label;
    };
    /// What held for a while: shaded from the bottom to the top, named at the bottom where there is room.
    struct Span {
        double begin = 0.0, end = 0.0;
        QString label;
        QColor colour;
    };
    /// What happened: a line from the bottom to the top, its text at the top where there is room.
    struct Instant {
        double x = 0.0;
        QString label;
    };

    QString title; ///< above the frame on the left
    QString xLabel;
    QString yLabel;
    AxisRange x;
    AxisRange y;
    std::vector<Mark> xMarks; ///< what the x axis shows; where there are none, its ticks, or whole numbers
    std::optional<Band> band;
    std::vector<Series> series; ///< those without points are left out of the legend
    std::vector<Span> spans;
    std::vector<Instant> instants; ///< from left to right
    double leastLeft = 0.0;        ///< of the frame, from the left of the area: plots in a column line up
    QString note;                  ///< in the upper half, when there is nothing to draw
};

void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, const PlotStyle& style);

} // namespace hexapose
