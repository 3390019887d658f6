// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/plot.h"

#include "ui/plot/nice_ticks.h"
#include "ui/plot/plot_marks.h"

#include <QFontMetricsF>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

const QColor kInk(0x22, 0x22, 0x22);
const QColor kAxis(0x80, 0x80, 0x80);
const QColor kGrid(0xD8, 0xD8, 0xD8);
constexpr double kTextSize = 13.0; // all sizes in units
constexpr double kTickTextSize = 12.0;
constexpr double kGap = 6.0;

/// One plot on its way to paper.
class PlotPainter {
public:
    PlotPainter(QPainter& painter, const QRectF& area, const Plot& plot, double unit);
    void paint();

private:
    void layOut();
    QPointF at(double x, double y) const;
    void paintNote();
    void paintBand();
    void paintGrid();
    void paintAxes();
    void paintTitle();
    void paintSeries(const Plot::Series& series);
    void paintLegend();
    void paintBandSwatch(QPointF left);
    double markerRadius() const;
    QPen pen(const QColor& colour, double width) const {
        return {colour, width * m_unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
    }

    QPainter& m_painter;
    QRectF m_area;
    const Plot& m_plot;
    double m_unit;
    QFont m_font;
    QFont m_tickFont;
    QFontMetricsF m_metrics;
    QFontMetricsF m_tickMetrics;
    Ticks m_xTicks;
    Ticks m_yTicks;
    QRectF m_frame;
};

PlotPainter::PlotPainter(QPainter& painter, const QRectF& area, const Plot& plot, double unit)
    : m_painter(painter), m_area(area), m_plot(plot), m_unit(unit), m_font(paperFont(kTextSize * unit)),
      m_tickFont(paperFont(kTickTextSize * unit)), m_metrics(m_font, painter.device()),
      m_tickMetrics(m_tickFont, painter.device()) {
    layOut();
}

void PlotPainter::layOut() {
    const double gap = kGap * m_unit;
    const double top = m_metrics.height() + 1.5 * gap;
    const double bottom =
        m_tickMetrics.height() + 2.0 * gap + (m_plot.xLabel.isEmpty() ? 0.0 : m_metrics.height());
    const double height = std::max(1.0, m_area.height() - top - bottom);
    m_yTicks = niceTicks(m_plot.y.low, m_plot.y.high,
                         std::max(2, static_cast<int>(height / (2.2 * m_tickMetrics.height()))));
    double labels =
        m_tickMetrics.horizontalAdvance(QStringLiteral("-0.00")); // plots above one another line up
    for (const QString& label : m_yTicks.labels)
        labels = std::max(labels, m_tickMetrics.horizontalAdvance(label));
    const double left = m_metrics.height() + labels + 3.0 * gap;
    const double width = std::max(1.0, m_area.width() - left - 2.0 * gap);
    m_frame = QRectF(m_area.left() + left, m_area.top() + top, width, height);
    const double xLabel = m_tickMetrics.horizontalAdvance(QString::number(m_plot.x.high, 'f', 0)) + 3.0 * gap;
    if (m_plot.xMarks.empty())
        m_xTicks =
            niceTicks(m_plot.x.low, m_plot.x.high, std::max(2, static_cast<int>(width / xLabel)), true);
    for (const Plot::Mark& mark : m_plot.xMarks) {
        m_xTicks.values.push_back(mark.x);
        m_xTicks.labels.push_back(mark.label);
    }
}

QPointF PlotPainter::at(double x, double y) const {
    const double right = (x - m_plot.x.low) / (m_plot.x.high - m_plot.x.low);
    const double up = (y - m_plot.y.low) / (m_plot.y.high - m_plot.y.low);
    return {m_frame.left() + right * m_frame.width(), m_frame.bottom() - up * m_frame.height()};
}

void PlotPainter::paint() {
    paintBand();
    paintGrid();
    m_painter.save();
    m_painter.setClipRect(m_frame.adjusted(-4 * m_unit, -4 * m_unit, 4 * m_unit, 4 * m_unit),
                          Qt::IntersectClip);
    for (const Plot::Series& series : m_plot.series)
        paintSeries(series);
    m_painter.restore();
    paintAxes();
    paintLegend();
    if (!m_plot.note.isEmpty())
        paintNote();
}

void PlotPainter::paintNote() {
    m_painter.setFont(m_font);
    const double margin = kGap * m_unit;
    QRectF box(QPointF(), QSizeF(m_metrics.horizontalAdvance(m_plot.note), m_metrics.height()));
    box.moveCenter(QPointF(m_frame.center().x(), m_frame.top() + m_frame.height() / 4.0));
    box.adjust(-margin, -margin, margin, margin);
    m_painter.fillRect(box, Qt::white);
    m_painter.setPen(kInk);
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
    m_painter.setPen(pen(kGrid, 0.7));
    for (const double y : m_yTicks.values)
        m_painter.drawLine(QPointF(m_frame.left(), at(0, y).y()), QPointF(m_frame.right(), at(0, y).y()));
    if (m_plot.y.low < 0.0 && m_plot.y.high > 0.0) {
        m_painter.setPen(pen(kAxis, 1.0));
        m_painter.drawLine(QPointF(m_frame.left(), at(0, 0).y()), QPointF(m_frame.right(), at(0, 0).y()));
    }
}

void PlotPainter::paintAxes() {
    const double gap = kGap * m_unit;
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(pen(kAxis, 1.0));
    m_painter.drawRect(m_frame);
    for (const double x : m_xTicks.values)
        m_painter.drawLine(QPointF(at(x, 0).x(), m_frame.bottom()),
                           QPointF(at(x, 0).x(), m_frame.bottom() + gap * 0.6));

    m_painter.setPen(kInk);
    m_painter.setFont(m_tickFont);
    const double line = m_tickMetrics.height();
    for (std::size_t i = 0; i < m_xTicks.values.size(); ++i) {
        const double x = at(m_xTicks.values[i], 0).x();
        m_painter.drawText(QRectF(x - 20 * line, m_frame.bottom() + gap, 40 * line, line), Qt::AlignCenter,
                           m_xTicks.labels[i]);
    }
    for (std::size_t i = 0; i < m_yTicks.values.size(); ++i) {
        const double y = at(0, m_yTicks.values[i]).y();
        m_painter.drawText(QRectF(m_area.left(), y - line, m_frame.left() - gap - m_area.left(), 2 * line),
                           Qt::AlignRight | Qt::AlignVCenter, m_yTicks.labels[i]);
    }
    m_painter.drawText(
        QRectF(m_frame.left(), m_area.top(), m_frame.width(), m_frame.top() - m_area.top() - gap / 2),
        Qt::AlignLeft | Qt::AlignBottom, timesPowerOfTen(m_yTicks.exponent));
    paintTitle();

    m_painter.setFont(m_font);
    const double text = m_metrics.height();
    m_painter.drawText(QRectF(m_frame.left(), m_area.bottom() - text, m_frame.width(), text), Qt::AlignCenter,
                       m_plot.xLabel);
    m_painter.save();
    m_painter.translate(m_area.left(), m_frame.center().y());
    m_painter.rotate(-90.0);
    m_painter.drawText(QRectF(-m_area.height(), 0.0, 2 * m_area.height(), text), Qt::AlignCenter,
                       m_plot.yLabel);
    m_painter.restore();
}

/// Beside the power of ten that belongs to the axis.
void PlotPainter::paintTitle() {
    const double power = m_tickMetrics.horizontalAdvance(timesPowerOfTen(m_yTicks.exponent));
    const double left = power > 0.0 ? power + 2.0 * kGap * m_unit : 0.0;
    m_painter.setFont(paperFont(kTextSize * m_unit, true));
    m_painter.drawText(QRectF(m_frame.left() + left, m_area.top(), m_frame.width() - left,
                              m_frame.top() - m_area.top() - kGap * m_unit / 2.0),
                       Qt::AlignLeft | Qt::AlignBottom, m_plot.title);
}

double PlotPainter::markerRadius() const {
    const double points = std::max(1.0, m_plot.x.high - m_plot.x.low);
    const double room = m_frame.width() / points;
    return std::clamp(room * 0.3, 1.6 * m_unit, 4.0 * m_unit);
}

void PlotPainter::paintSeries(const Plot::Series& series) {
    QPolygonF run;
    const double radius = markerRadius();
    // Lines between a great many samples would hide the samples.
    const bool crowded = radius <= kCrowdedMarker * m_unit && series.marker != Plot::Marker::None;
    QColor colour = series.colour;
    colour.setAlphaF(crowded ? 0.45F : 1.0F);
    m_painter.setPen(pen(colour, crowded ? 0.7 : 1.5));
    m_painter.setBrush(Qt::NoBrush);
    const auto paintRun = [&] {
        if (series.connected && run.size() > 1)
            m_painter.drawPolyline(run);
        run.clear();
    };
    for (const QPointF& point : series.points) {
        if (std::isfinite(point.y()))
            run << at(point.x(), point.y());
        else
            paintRun();
    }
    paintRun();
    for (const QPointF& point : series.points)
        if (std::isfinite(point.y()))
            paintPlotMarker(m_painter, series.marker, series.colour, at(point.x(), point.y()), radius,
                            m_unit);
}

/// From the right edge of the frame to the left, above it.
void PlotPainter::paintLegend() {
    m_painter.setFont(m_font);
    const double swatch = kSwatchWidth * m_unit;
    const double gap = kGap * m_unit;
    const double y = m_frame.top() - gap / 2 - m_metrics.height() / 2;
    double right = m_frame.right();
    const auto place = [&](const QString& name, const Plot::Series* series) {
        const double width = m_metrics.horizontalAdvance(name);
        m_painter.setPen(kInk);
        m_painter.drawText(
            QRectF(right - width - gap, y - m_metrics.height(), width + gap, 2 * m_metrics.height()),
            Qt::AlignRight | Qt::AlignVCenter, name);
        right -= width + gap + swatch;
        if (series != nullptr)
            paintSwatch(m_painter, *series, QPointF(right, y), m_unit);
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
    m_painter.setPen(pen(kGrid, 0.7));
    m_painter.setBrush(m_plot.band->colour);
    m_painter.drawRect(QRectF(left - QPointF(0, 5 * m_unit), QSizeF(kSwatchWidth * m_unit, 10 * m_unit)));
}

} // namespace

void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, double unit) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::TextAntialiasing);
    PlotPainter(painter, area, plot, unit).paint();
    painter.restore();
}

QFont paperFont(double pixels, bool bold) {
    QFont font;
    font.setFamilies(
        {QStringLiteral("DejaVu Sans"), QStringLiteral("Noto Sans"), QStringLiteral("Liberation Sans")});
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(pixels))));
    font.setBold(bold);
    return font;
}

} // namespace hexapose
