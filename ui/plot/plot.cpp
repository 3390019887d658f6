// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/plot.h"

#include "ui/plot/plot_curve.h"
#include "ui/plot/plot_layout.h"
#include "ui/plot/plot_marks.h"
#include "ui/plot/plot_times.h"

#include <QFontMetricsF>
#include <QPaintEngine>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kAxisWidth = 1.0; // in units
constexpr double kGridWidth = 0.7;
constexpr double kCurveWidth = 1.5;
constexpr double kFinePixel = 0.7;
constexpr double kDenseLength =
    6.0; ///< widths of the frame: a longer curve is drawn thin and without smoothing

/// One plot on its way to paper or to the screen.
class PlotPainter {
public:
    PlotPainter(QPainter& painter, const QRectF& area, const Plot& plot, const PlotStyle& style);
    void paint();

private:
    QPointF at(double x, double y) const { return m_layout.scale.at(x, y); }
    void paintNote();
    void paintBand();
    void paintGrid();
    void paintFrame();
    void paintAxes();
    void paintTitle();
    void paintSeries(const Plot::Series& series);
    void paintReduced(const Plot::Series& series, QPen line);
    void paintLegend();
    double legendWidth() const;
    void paintBandSwatch(QPointF left);
    double markerRadius() const;
    double gap() const { return kPlotGap * m_style.unit; }
    QPen pen(const QColor& colour, double width) const {
        return {colour, width * m_style.unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
    }
    /// Of frame and grid, which lie on pixels where there are some.
    QPen rule(const QColor& colour, double width) const {
        return m_style.pixel > 0.0 ? QPen(colour, m_style.pixel) : pen(colour, width);
    }
    void drawHorizontal(double y) {
        const double level = m_style.onPixel(at(0, y).y());
        m_painter.drawLine(QPointF(m_frame.left(), level), QPointF(m_frame.right(), level));
    }

    QPainter& m_painter;
    QRectF m_area;
    const Plot& m_plot;
    const PlotStyle& m_style;
    QFontMetricsF m_metrics;
    QFontMetricsF m_tickMetrics;
    PlotLayout m_layout;
    QRectF m_frame;
};

PlotPainter::PlotPainter(QPainter& painter, const QRectF& area, const Plot& plot, const PlotStyle& style)
    : m_painter(painter), m_area(area), m_plot(plot), m_style(style), m_metrics(style.font, painter.device()),
      m_tickMetrics(style.tickFont, painter.device()),
      m_layout(layOutPlot(plot, area, style, *painter.device())), m_frame(m_layout.scale.frame) {}

void PlotPainter::paint() {
    paintBand();
    paintSpans(m_painter, m_plot, m_layout, m_style);
    paintGrid();
    paintInstants(m_painter, m_plot, m_layout, m_style);
    for (const Plot::Series& series : m_plot.series) {
        m_painter.save();
        // A marker on the frame is shown whole; a curve ends there.
        const double over = (series.marker == Plot::Marker::None ? 1.0 : 4.0) * m_style.unit;
        m_painter.setClipRect(m_frame.adjusted(-over, -over, over, over), Qt::IntersectClip);
        paintSeries(series);
        m_painter.restore();
    }
    paintFrame();
    paintAxes();
    paintLegend();
    if (!m_plot.note.isEmpty())
        paintNote();
}

void PlotPainter::paintNote() {
    m_painter.setFont(m_style.font);
    const double margin = gap();
    QRectF box(QPointF(), QSizeF(m_metrics.horizontalAdvance(m_plot.note), m_metrics.height()));
    box.moveCenter(QPointF(m_frame.center().x(), m_frame.top() + m_frame.height() / 4.0));
    box.adjust(-margin, -margin, margin, margin);
    m_painter.fillRect(box, m_style.ground);
    m_painter.setPen(m_style.text);
    m_painter.drawText(box, Qt::AlignCenter, m_plot.note);
}

void PlotPainter::paintBand() {
    if (!m_plot.band)
        return;
    // One outline, because steps drawn side by side show seams where a renderer smooths their edges.
    QPolygonF upper;
    QPolygonF lower;
    for (const QPointF& step : m_plot.band->steps) {
        const double y = std::isnan(step.y()) ? 0.0 : std::min(step.y(), m_plot.y.high);
        for (const double x : {step.x() - 0.5, step.x() + 0.5}) {
            upper << at(x, y);
            lower << at(x, std::max(-y, m_plot.y.low));
        }
    }
    std::reverse(lower.begin(), lower.end());
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(m_plot.band->colour);
    m_painter.drawPolygon(upper + lower);
}

void PlotPainter::paintGrid() {
    m_painter.setRenderHint(QPainter::Antialiasing, m_style.pixel <= 0.0);
    m_painter.setPen(rule(m_style.grid, kGridWidth));
    for (const double y : m_layout.yTicks.values)
        drawHorizontal(y);
    for (const double x : m_layout.xTicks.values) {
        const double column = m_style.onPixel(at(x, 0).x());
        if (m_style.verticalGrid)
            m_painter.drawLine(QPointF(column, m_frame.top()), QPointF(column, m_frame.bottom()));
    }
    if (m_plot.y.low < 0.0 && m_plot.y.high > 0.0) {
        m_painter.setPen(rule(m_style.axis, kAxisWidth));
        drawHorizontal(0.0);
    }
    m_painter.setRenderHint(QPainter::Antialiasing);
}

void PlotPainter::paintFrame() {
    m_painter.setRenderHint(QPainter::Antialiasing, m_style.pixel <= 0.0);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(rule(m_style.axis, kAxisWidth));
    m_painter.drawRect(m_frame);
    for (const double x : m_layout.xTicks.values) {
        const double column = m_style.onPixel(at(x, 0).x());
        m_painter.drawLine(QPointF(column, m_frame.bottom()),
                           QPointF(column, m_frame.bottom() + gap() * 0.6));
    }
    m_painter.setRenderHint(QPainter::Antialiasing);
}

void PlotPainter::paintAxes() {
    m_painter.setPen(m_style.label);
    m_painter.setFont(m_style.tickFont);
    const double line = m_tickMetrics.height();
    for (std::size_t i = 0; i < m_layout.xTicks.values.size(); ++i) {
        // Whole within the area, also a long one under the end of the axis.
        const double half = m_tickMetrics.horizontalAdvance(m_layout.xTicks.labels[i]) / 2.0;
        const double x = std::max(m_area.left() + half,
                                  std::min(at(m_layout.xTicks.values[i], 0).x(), m_area.right() - half));
        m_painter.drawText(QRectF(x - 20 * line, m_frame.bottom() + gap(), 40 * line, line), Qt::AlignCenter,
                           m_layout.xTicks.labels[i]);
    }
    for (std::size_t i = 0; i < m_layout.yTicks.values.size(); ++i) {
        const double y = at(0, m_layout.yTicks.values[i]).y();
        m_painter.drawText(QRectF(m_area.left(), y - line, m_frame.left() - gap() - m_area.left(), 2 * line),
                           Qt::AlignRight | Qt::AlignVCenter, m_layout.yTicks.labels[i]);
    }
    m_painter.drawText(
        QRectF(m_frame.left(), m_area.top(), m_frame.width(), m_frame.top() - m_area.top() - gap() / 2),
        Qt::AlignLeft | Qt::AlignBottom, timesPowerOfTen(m_layout.yTicks.exponent));
    m_painter.setFont(m_style.font);
    const double text = m_metrics.height();
    m_painter.drawText(QRectF(m_frame.left(), m_area.bottom() - text, m_frame.width(), text), Qt::AlignCenter,
                       m_plot.xLabel);
    m_painter.save();
    m_painter.translate(m_area.left(), m_frame.center().y());
    m_painter.rotate(-90.0);
    m_painter.drawText(QRectF(-m_area.height(), 0.0, 2 * m_area.height(), text), Qt::AlignCenter,
                       m_plot.yLabel);
    m_painter.restore();
    paintTitle();
}

/// Beside the power of ten that belongs to the axis.
void PlotPainter::paintTitle() {
    const double power = m_tickMetrics.horizontalAdvance(timesPowerOfTen(m_layout.yTicks.exponent));
    const double left = power > 0.0 ? power + 2.0 * gap() : 0.0;
    m_painter.setFont(m_style.titleFont);
    m_painter.setPen(m_style.text);
    const double width = m_frame.width() - left - legendWidth();
    const QString title = QFontMetricsF(m_style.titleFont, m_painter.device())
                              .elidedText(m_plot.title, Qt::ElideRight, std::max(0.0, width));
    m_painter.drawText(QRectF(m_frame.left() + left, m_area.top(), m_frame.width() - left,
                              m_frame.top() - m_area.top() - gap() / 2.0),
                       Qt::AlignLeft | Qt::AlignBottom, title);
}

double PlotPainter::markerRadius() const {
    const double points = std::max(1.0, m_plot.x.high - m_plot.x.low);
    const double room = m_frame.width() / points;
    return std::clamp(room * 0.3, 1.6 * m_style.unit, 4.0 * m_style.unit);
}

void PlotPainter::paintSeries(const Plot::Series& series) {
    const double radius = markerRadius();
    const bool marked = series.marker != Plot::Marker::None;
    if (series.connected) {
        // Lines between a great many samples would hide the samples.
        const bool crowded = radius <= kCrowdedMarker * m_style.unit && marked;
        QColor colour = series.colour;
        colour.setAlphaF(crowded ? 0.45F : 1.0F);
        QPen line = pen(colour, crowded ? 0.7 : kCurveWidth);
        line.setStyle(series.line);
        if (series.line != Qt::SolidLine)
            line.setCapStyle(Qt::FlatCap); // a round end fills the space between dashes
        if (m_style.pixel > 0.0)
            line.setJoinStyle(
                Qt::BevelJoin); // round ones take twice the time, and none is larger than a pixel
        if (series.isReduced)
            paintReduced(series, line);
        else
            paintCurve(m_painter, curvePieces(series.points, m_layout.scale, m_style.column()), line);
    }
    if (!marked)
        return;
    for (const QPointF& point : series.points)
        if (std::isfinite(point.y()))
            paintPlotMarker(m_painter, series.marker, series.colour, at(point.x(), point.y()), radius,
                            m_style);
}

/// On a screen, a pixel wide, which takes a tenth of the time of any wider line. Where a curve fills its
/// pixels smoothing shows nothing, and costs time again.
void PlotPainter::paintReduced(const Plot::Series& series, QPen line) {
    const CurvePieces pieces = wholePieces(series.points, m_layout.scale);
    const bool hasPixels = m_painter.paintEngine()->type() == QPaintEngine::Raster;
    const double longest = kDenseLength * m_frame.width();
    const bool isDense = hasPixels && curveLength(pieces, longest) >= longest;
    if (isDense || m_style.pixel > 0.0)
        line.setWidthF(0.0); // one pixel of the device
    m_painter.setRenderHint(QPainter::Antialiasing, !isDense);
    paintCurve(m_painter, pieces, line);
    if (m_style.pixel > 0.0 && m_style.pixel < kFinePixel) // where pixels are small, one is too thin
        for (const QPointF& step : {QPointF(m_style.pixel, 0.0), QPointF(0.0, m_style.pixel)}) {
            m_painter.translate(step);
            paintCurve(m_painter, pieces, line);
            m_painter.translate(-step);
        }
    m_painter.setRenderHint(QPainter::Antialiasing);
}

double PlotPainter::legendWidth() const {
    double width = 0.0;
    for (const Plot::Series& series : m_plot.series)
        if (!series.points.empty() && !series.name.isEmpty())
            width += m_metrics.horizontalAdvance(series.name) + kSwatchWidth * m_style.unit + 3.5 * gap();
    return width;
}

/// From the right edge of the frame to the left, above it.
void PlotPainter::paintLegend() {
    m_painter.setFont(m_style.font);
    const double swatch = kSwatchWidth * m_style.unit;
    const double gap = this->gap();
    const double y = m_frame.top() - gap / 2 - m_metrics.height() / 2;
    double right = m_frame.right();
    const auto place = [&](const QString& name, const Plot::Series* series) {
        const double width = m_metrics.horizontalAdvance(name);
        m_painter.setPen(m_style.text);
        m_painter.drawText(
            QRectF(right - width - gap, y - m_metrics.height(), width + gap, 2 * m_metrics.height()),
            Qt::AlignRight | Qt::AlignVCenter, name);
        right -= width + gap + swatch;
        if (series != nullptr)
            paintSwatch(m_painter, *series, QPointF(right, y), m_style);
        else
            paintBandSwatch(QPointF(right, y));
        right -= 2.5 * gap;
    };
    if (m_plot.band && !m_plot.band->steps.empty())
        place(m_plot.band->name, nullptr);
    std::for_each(m_plot.series.rbegin(), m_plot.series.rend(), [&](const Plot::Series& series) {
        if (!series.points.empty() && !series.name.isEmpty())
            place(series.name, &series);
    });
}

void PlotPainter::paintBandSwatch(QPointF left) {
    m_painter.setPen(rule(m_style.grid, kGridWidth));
    m_painter.setBrush(m_plot.band->colour);
    m_painter.drawRect(
        QRectF(left - QPointF(0, 5 * m_style.unit), QSizeF(kSwatchWidth * m_style.unit, 10 * m_style.unit)));
}

} // namespace

void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, const PlotStyle& style) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::TextAntialiasing);
    PlotPainter(painter, area, plot, style).paint();
    painter.restore();
}

} // namespace hexapose
