// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/plot_curve.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kDotWidth = 3.0;
constexpr double kAlike = 0.2; ///< pixels between points that are one to the eye
constexpr double kBeyond =
    1e6; ///< pixels outside the frame, where a value far away is as good as at its place

/// Takes points of the device and writes the pieces, column by column.
class ColumnReducer {
public:
    ColumnReducer(CurvePieces& pieces, double width) : m_pieces(pieces), m_width(width) {}

    void add(QPointF point) {
        if (m_empty) {
            m_pieces.emplace_back();
            m_pieces.back() << point;
        }
        const double column = std::floor(point.x() / m_width);
        if (!m_empty && column == m_column) {
            widen(point);
        } else {
            flush();
            m_column = column;
            m_first = m_second = point;
        }
        m_last = point;
        m_empty = false;
    }

    /// The ends of a piece stay where they are.
    void endPiece() {
        if (m_empty)
            return;
        flush();
        put(m_last);
        m_empty = true;
    }

private:
    /// m_first and m_second are the extremes of the column, in the order of the curve.
    void widen(QPointF point) {
        const bool rising = m_second.y() >= m_first.y();
        const QPointF low = rising ? m_first : m_second;
        const QPointF high = rising ? m_second : m_first;
        if (point.y() < low.y()) {
            m_first = high;
            m_second = point;
        } else if (point.y() > high.y()) {
            m_first = low;
            m_second = point;
        }
    }
    void flush() {
        if (m_empty)
            return;
        put(m_first);
        put(m_second);
    }
    void put(QPointF point) {
        QPolygonF& piece = m_pieces.back();
        if (piece.back() != point)
            piece << point;
    }

    CurvePieces& m_pieces;
    double m_width;
    double m_column = 0.0;
    bool m_empty = true;
    QPointF m_first;
    QPointF m_second;
    QPointF m_last;
};

} // namespace

CurvePieces curvePieces(const std::vector<QPointF>& points, const PlotScale& scale, double column) {
    CurvePieces pieces;
    ColumnReducer reducer(pieces, column);
    for (const QPointF& point : points) {
        if (std::isfinite(point.y()))
            reducer.add(scale.at(point.x(), point.y()));
        else
            reducer.endPiece();
    }
    reducer.endPiece();
    return pieces;
}

CurvePieces wholePieces(const std::vector<QPointF>& points, const PlotScale& scale) {
    CurvePieces pieces;
    bool isBroken = true;
    const double top = scale.frame.top() - kBeyond, bottom = scale.frame.bottom() + kBeyond;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::isfinite(points[i].y())) {
            isBroken = true;
            continue;
        }
        QPointF at = scale.at(points[i].x(), points[i].y());
        at.setY(std::clamp(at.y(), top, bottom));
        const bool isLast = i + 1 == points.size() || !std::isfinite(points[i + 1].y());
        if (isBroken)
            pieces.emplace_back();
        else if (!isLast && (at - pieces.back().back()).manhattanLength() < kAlike)
            continue;
        pieces.back() << at;
        isBroken = false;
    }
    return pieces;
}

double curveLength(const CurvePieces& pieces, double most) {
    double length = 0.0;
    for (const QPolygonF& piece : pieces)
        for (qsizetype i = 1; i < piece.size() && length < most; ++i)
            length += (piece[i] - piece[i - 1]).manhattanLength();
    return length;
}

void paintCurve(QPainter& painter, const CurvePieces& pieces, const QPen& pen) {
    painter.setBrush(Qt::NoBrush);
    for (const QPolygonF& piece : pieces) {
        QPen used = pen;
        if (piece.size() > 1) {
            painter.setPen(used);
            painter.drawPolyline(piece);
        } else {
            used.setStyle(Qt::SolidLine);
            used.setCapStyle(Qt::RoundCap);
            if (used.widthF() <= 0.0) // of a pixel, which is hard to see alone
                used.setWidthF(kDotWidth);
            painter.setPen(used);
            painter.drawPoint(piece.front());
        }
    }
}

} // namespace hexapose
