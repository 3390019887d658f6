// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

namespace hexapose {

/// A diagram on paper: vector drawing at any size, for print and for files. The live charts are another
/// matter.
struct Plot {
    /// Told apart by shape as well as by colour.
    enum class Marker { Circle, Square, Triangle, Cross, Ring, None };
    struct Series {
        QString name; ///< empty: not in the legend
        QColor colour;
        Marker marker = Marker::Circle;
        bool connected = true;
        std::vector<QPointF> points; ///< a y that is not finite is a gap
    };
    /// Shaded steps of width 1 around whole x, from -y to y; unbounded where y is infinite.
    struct Band {
        QString name;
        QColor colour;
        std::vector<QPointF> steps;
    };
    struct Range {
        double low = 0.0;
        double high = 1.0;
    };

    struct Mark {
        double x;
        QString label;
    };

    QString title; ///< above the frame on the left
    QString xLabel;
    QString yLabel;
    Range x;
    Range y;
    std::vector<Mark> xMarks; ///< what the x axis shows; whole numbers where there are none
    std::optional<Band> band;
    std::vector<Series> series; ///< those without points are left out of the legend
    QString note;               ///< in the upper half, when there is nothing to draw
};

/// `unit` is the size of everything that is not data: 1 gives text of 13 px and lines of about 1 px.
void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, double unit);

/// The face of all printed text, at a size in pixels of the device.
QFont paperFont(double pixels, bool bold = false);

} // namespace hexapose
