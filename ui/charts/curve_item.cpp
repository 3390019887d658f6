// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/curve_item.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace hexapose {

CurveItem::CurveItem(QGraphicsItem* parent) : QGraphicsItem(parent) {
    setZValue(10.0);
}

void CurveItem::setArea(const QRectF& area) {
    if (area != m_area) {
        prepareGeometryChange();
        m_area = area;
    }
}

void CurveItem::setWindow(double from, double to, const AxisRange& range) {
    m_from = from;
    m_to = to;
    m_range = range;
    update();
}

void CurveItem::setCurves(std::vector<Curve> curves) {
    m_curves = std::move(curves);
    update();
}

void CurveItem::setCursor(std::optional<Cursor> cursor) {
    m_cursor = std::move(cursor);
    update();
}

void CurveItem::setCursorColors(const QColor& line, const QColor& text, const QColor& ground) {
    m_cursorLine = line;
    m_cursorText = text;
    m_cursorGround = ground;
    update();
}

QPointF CurveItem::toPlot(const QPointF& point) const {
    return {m_area.left() + (point.x() - m_from) / (m_to - m_from) * m_area.width(),
            m_area.bottom() - (point.y() - m_range.low) / (m_range.high - m_range.low) * m_area.height()};
}

double CurveItem::timeAt(double x) const {
    return m_area.width() > 0.0 ? m_from + (x - m_area.left()) / m_area.width() * (m_to - m_from) : m_from;
}

void CurveItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* /*option*/, QWidget* /*widget*/) {
    if (!(m_to > m_from) || !(m_range.high > m_range.low)) {
        return;
    }
    painter->save();
    painter->setClipRect(m_area.adjusted(-1, -1, 1, 1));
    painter->setRenderHint(QPainter::Antialiasing);
    for (const Curve& curve : m_curves) {
        painter->setPen(curve.pen);
        for (const auto& piece : curve.pieces) {
            QPolygonF line;
            line.reserve(static_cast<qsizetype>(piece.size()));
            for (const QPointF& point : piece) {
                line.append(toPlot(point));
            }
            if (line.size() == 1) {
                painter->drawPoint(line.first()); // a single sample between two gaps
            } else {
                painter->drawPolyline(line);
            }
        }
    }
    paintCursor(*painter);
    painter->restore();
}

void CurveItem::paintCursor(QPainter& painter) const {
    if (!m_cursor || m_cursor->time < m_from || m_cursor->time > m_to) {
        return;
    }
    const double x = toPlot({m_cursor->time, m_range.low}).x();
    painter.setPen(QPen(m_cursorLine, 1.0, Qt::DotLine));
    painter.drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom()));
    const QFontMetricsF metrics(painter.font());
    const QSizeF size = metrics.size(0, m_cursor->text) + QSizeF(10.0, 4.0);
    // Beside the line, on the side where there is room.
    double left = x + 5.0;
    if (left + size.width() > m_area.right()) {
        left = std::max(x - 5.0 - size.width(), m_area.left());
    }
    const QRectF box(QPointF(left, m_area.top() + 2.0), size);
    painter.setPen(QPen(m_cursorLine, 1.0));
    painter.setBrush(m_cursorGround);
    painter.drawRoundedRect(box, 3.0, 3.0);
    painter.setPen(m_cursorText);
    painter.drawText(box, Qt::AlignCenter, m_cursor->text);
}

} // namespace hexapose
