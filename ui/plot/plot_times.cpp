// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/plot_times.h"

#include <QFontMetricsF>

#include <algorithm>

namespace hexapose {

namespace {

constexpr double kTextGap = 3.0;    // in units
constexpr double kLeastText = 24.0; ///< less room says nothing
constexpr double kLongestText = 260.0;
constexpr double kCrowdedInstant = 30.0;
constexpr float kCrowdedAlpha = 0.3F;

} // namespace

void paintSpans(QPainter& painter, const Plot& plot, const PlotLayout& layout, const PlotStyle& style) {
    if (plot.spans.empty())
        return;
    const QRectF& frame = layout.scale.frame;
    const QFontMetricsF metrics(style.tickFont, painter.device());
    const double gap = kTextGap * style.unit;
    painter.save();
    painter.setClipRect(frame, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing, false); // no seams between neighbours
    painter.setFont(style.tickFont);
    for (const Plot::Span& span : plot.spans) {
        const double left = std::max(frame.left(), layout.scale.at(span.begin, 0.0).x());
        const double right = std::min(frame.right(), layout.scale.at(span.end, 0.0).x());
        if (!(right >= left))
            continue;
        painter.fillRect(QRectF(left, frame.top(), std::max(right - left, style.pixel), frame.height()),
                         span.colour);
        const double room = right - left - 2.0 * gap;
        if (room < kLeastText * style.unit)
            continue;
        painter.setPen(style.label);
        painter.drawText(QRectF(left + gap, frame.bottom() - metrics.height() - gap, room, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(span.label, Qt::ElideRight, room));
    }
    painter.restore();
}

void paintInstants(QPainter& painter, const Plot& plot, const PlotLayout& layout, const PlotStyle& style) {
    if (plot.instants.empty())
        return;
    const QRectF& frame = layout.scale.frame;
    const QFontMetricsF metrics(style.tickFont, painter.device());
    const double gap = kTextGap * style.unit;
    painter.save();
    painter.setClipRect(frame, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing, style.pixel <= 0.0);
    painter.setFont(style.tickFont);
    // A crowd of them shall not hide the curves.
    const double crowd = frame.width() / (kCrowdedInstant * style.unit);
    QColor line = style.label;
    if (static_cast<double>(plot.instants.size()) > crowd)
        line.setAlphaF(kCrowdedAlpha);
    double taken = frame.left();
    for (std::size_t i = 0; i < plot.instants.size(); ++i) {
        const Plot::Instant& instant = plot.instants[i];
        const double x = style.onPixel(layout.scale.at(instant.x, 0.0).x());
        if (x < frame.left() || x > frame.right())
            continue;
        painter.setPen(QPen(line, style.pixel > 0.0 ? style.pixel : style.unit, Qt::DotLine));
        painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
        double end = frame.right();
        if (i + 1 < plot.instants.size())
            end = std::min(end, layout.scale.at(plot.instants[i + 1].x, 0.0).x());
        const double room = std::min(end - x - 2.0 * gap, kLongestText * style.unit);
        if (x < taken || room < kLeastText * style.unit)
            continue;
        const QString text = metrics.elidedText(instant.label, Qt::ElideRight, room);
        painter.setPen(style.text);
        painter.drawText(QRectF(x + gap, frame.top() + gap, room, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, text);
        taken = x + gap + metrics.horizontalAdvance(text);
    }
    painter.restore();
}

} // namespace hexapose
