// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/plot_marks.h"

#include <QPolygonF>

namespace hexapose {

namespace {

constexpr double kSwatchMarker = 4.0;
constexpr double kRingOverCircle = 1.75; ///< a circle in a ring of its size shows both

QPen pen(const QColor& colour, double width) {
    return {colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

} // namespace

void paintPlotMarker(QPainter& painter, Plot::Marker marker, const QColor& colour, QPointF centre,
                     double radius, const PlotStyle& style) {
    const QPointF right(radius, 0.0);
    const QPointF down(0.0, radius);
    if (marker == Plot::Marker::None)
        return;
    if (marker == Plot::Marker::Cross) {
        painter.setPen(pen(colour, 0.45 * radius));
        painter.drawLine(centre - right - down, centre + right + down);
        painter.drawLine(centre - right + down, centre + right - down);
        return;
    }
    if (marker == Plot::Marker::Ring) {
        painter.setPen(pen(colour, 0.35 * radius));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, kRingOverCircle * radius, kRingOverCircle * radius);
        return;
    }
    if (radius > kCrowdedMarker * style.unit)
        painter.setPen(pen(style.ground, 0.6 * style.unit)); // keeps markers apart that lie on one another
    else
        painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    if (marker == Plot::Marker::Circle)
        painter.drawEllipse(centre, radius, radius);
    else if (marker == Plot::Marker::Square)
        painter.drawRect(QRectF(centre - 0.9 * (right + down), centre + 0.9 * (right + down)));
    else
        painter.drawPolygon(QPolygonF{centre - 1.25 * down, centre + 1.1 * right + 0.85 * down,
                                      centre - 1.1 * right + 0.85 * down});
}

void paintSwatch(QPainter& painter, const Plot::Series& series, QPointF left, const PlotStyle& style) {
    const QPointF end(kSwatchWidth * style.unit, 0.0);
    if (series.connected) {
        QPen line = pen(series.colour, 1.5 * style.unit);
        line.setStyle(series.line);
        painter.setPen(line);
        painter.drawLine(left, left + end);
    }
    paintPlotMarker(painter, series.marker, series.colour, left + 0.5 * end, kSwatchMarker * style.unit,
                    style);
}

} // namespace hexapose
