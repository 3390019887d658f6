// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/chart_history.h"
#include "ui/charts/chart_range.h"

#include <QGraphicsItem>
#include <QPen>
#include <QRectF>
#include <QString>

#include <optional>

namespace hexapose {

/// Draws curves with gaps, and the cursor, into the plot area of a chart; QLineSeries cannot leave a gap.
class CurveItem final : public QGraphicsItem {
public:
    struct Curve {
        CurvePieces pieces;
        QPen pen;
    };
    struct Cursor {
        double time;
        QString text;
    };

    explicit CurveItem(QGraphicsItem* parent);
    void setArea(const QRectF& area);
    void setWindow(double from, double to, const AxisRange& range);
    void setCurves(std::vector<Curve> curves);
    void setCursor(std::optional<Cursor> cursor);
    void setCursorColors(const QColor& line, const QColor& text, const QColor& ground);

    QRectF boundingRect() const override { return m_area; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
    double timeAt(double x) const;

private:
    QPointF toPlot(const QPointF& point) const;
    void paintCursor(QPainter& painter) const;

    QRectF m_area;
    double m_from = 0.0;
    double m_to = 1.0;
    AxisRange m_range;
    std::vector<Curve> m_curves;
    std::optional<Cursor> m_cursor;
    QColor m_cursorLine;
    QColor m_cursorText;
    QColor m_cursorGround;
};

} // namespace hexapose
