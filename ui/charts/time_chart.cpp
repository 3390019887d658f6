// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/time_chart.h"

#include "core/base/number_text.h"
#include "ui/charts/chart_style.h"

#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hexapose {

namespace {

constexpr double kTimeTicks = 5.0;
constexpr double kRounding = 8.0; ///< of the card's corners
constexpr double kMargin = 4.0;

QString cursorNumber(double value, int decimals) {
    return std::isfinite(value) ? QString::fromStdString(formatFixed(value, decimals)) : QStringLiteral("--");
}

std::optional<std::pair<double, double>> together(const std::optional<std::pair<double, double>>& a,
                                                  const std::optional<std::pair<double, double>>& b) {
    if (!a || !b) {
        return a ? a : b;
    }
    return std::pair(std::min(a->first, b->first), std::max(a->second, b->second));
}

/// Bit by bit, because a gap, NaN, is like another gap.
bool samePoints(const std::vector<QPointF>& a, const std::vector<QPointF>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(QPointF)) == 0);
}

bool sameCurves(const std::vector<Plot::Series>& a, const std::vector<Plot::Series>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Plot::Series& one, const Plot::Series& other) {
                          return one.colour == other.colour && one.line == other.line &&
                                 samePoints(one.points, other.points);
                      });
}

} // namespace

TimeChart::TimeChart(QWidget* parent) : QWidget(parent), m_colors(themeColors(ThemeKind::Light)) {
    setMouseTracking(true);
    setMinimumSize(200, 130);
    setSubject({});
}

void TimeChart::setSubject(const ChartSubject& subject) {
    const bool same = subject.measured == m_subject.measured && subject.target == m_subject.target;
    m_subject = subject;
    m_plot.title = subject.title;
    m_plot.yLabel = subject.unit;
    if (!same || m_plot.series.empty()) { // another language leaves the curves as they are
        m_plot.y = grownRange(subject.low, subject.high, std::nullopt);
        m_plot.series.clear();
        m_cursor.reset();
    }
    setAccessibleName(subject.title);
    update();
}

void TimeChart::setTimeTitle(const QString& title) {
    m_plot.xLabel = title;
    update();
}

void TimeChart::setColors(const ThemeColors& colors) {
    m_colors = colors;
    for (Plot::Series& series : m_plot.series) {
        series.colour = series.line == Qt::SolidLine ? colors.accent : colors.muted;
    }
    update();
}

void TimeChart::showWindow(const ChartHistory& history, double from, double to) {
    auto reach = history.range(m_subject.measured, from, to);
    std::vector<Plot::Series> curves;
    const auto add = [&](std::size_t channel, const QColor& colour, Qt::PenStyle line) {
        curves.push_back({{}, colour, Plot::Marker::None, true, history.curve(channel, from, to), line});
    };
    if (m_subject.target) {
        reach = together(reach, history.range(*m_subject.target, from, to));
        add(*m_subject.target, m_colors.muted, Qt::DashLine);
    }
    add(m_subject.measured, m_colors.accent, Qt::SolidLine);
    const AxisRange time{from, to, niceStep((to - from) / kTimeTicks)};
    const AxisRange value = grownRange(m_subject.low, m_subject.high, reach);
    if (time == m_plot.x && value == m_plot.y && sameCurves(curves, m_plot.series)) {
        return;
    }
    m_plot.x = time;
    m_plot.y = value;
    m_plot.series = std::move(curves);
    update();
}

void TimeChart::showCursor(const ChartHistory& history, std::optional<double> time) {
    std::optional<Cursor> cursor;
    if (time) {
        QString values = cursorNumber(history.valueAt(m_subject.measured, *time), m_subject.decimals);
        if (m_subject.target) {
            values += QStringLiteral(" / ") +
                      cursorNumber(history.valueAt(*m_subject.target, *time), m_subject.decimals);
        }
        cursor = Cursor{*time, cursorNumber(*time, 2) + QStringLiteral(" s"),
                        values + QLatin1Char(' ') + m_subject.unit};
    }
    if (cursor != m_cursor) {
        m_cursor = std::move(cursor);
        update();
    }
}

QRectF TimeChart::plotArea() const {
    return QRectF(rect()).adjusted(kMargin, kMargin, -kMargin / 2.0, -kMargin);
}

PlotLayout TimeChart::layOut() const {
    return layOutPlot(m_plot, plotArea(), chartStyle(m_colors, *this), *this);
}

void TimeChart::paintEvent(QPaintEvent* /*event*/) {
    const PlotStyle style = chartStyle(m_colors, *this);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_colors.border, style.pixel));
    painter.setBrush(style.ground);
    const double half = style.pixel / 2.0;
    painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), kRounding, kRounding);
    paintPlot(painter, plotArea(), m_plot, style);
    paintCursor(painter, style);
}

void TimeChart::paintCursor(QPainter& painter, const PlotStyle& style) const {
    if (!m_cursor || m_cursor->at < m_plot.x.low || m_cursor->at > m_plot.x.high) {
        return;
    }
    const PlotScale scale = layOut().scale;
    const QRectF& frame = scale.frame;
    const double x = style.onPixel(scale.at(m_cursor->at, 0.0).x());
    painter.setPen(QPen(style.label, 1.0, Qt::DotLine));
    painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
    const QFontMetricsF metrics(style.font, this);
    const QSizeF margins(10.0, 4.0);
    QString text = m_cursor->time + QStringLiteral("   ") + m_cursor->values;
    QSizeF size = metrics.size(0, text) + margins;
    if (size.width() > frame.width()) {
        text = m_cursor->time + QLatin1Char('\n') + m_cursor->values;
        size = metrics.size(0, text) + margins;
    }
    // Beside the line, on the side where there is room.
    double left = x + 5.0;
    if (left + size.width() > frame.right()) {
        left = std::max(x - 5.0 - size.width(), frame.left());
    }
    const QRectF box(QPointF(left, frame.top() + 2.0), size);
    painter.setFont(style.font);
    painter.setPen(QPen(style.label, style.pixel));
    painter.setBrush(style.ground);
    painter.drawRoundedRect(box, 3.0, 3.0);
    painter.setPen(style.text);
    painter.drawText(box, Qt::AlignCenter, text);
}

void TimeChart::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps != 0.0) {
        emit zoomed(std::pow(0.8, steps));
    }
    event->accept();
}

void TimeChart::mouseMoveEvent(QMouseEvent* event) {
    const PlotScale scale = layOut().scale;
    if (scale.frame.contains(event->position())) {
        emit cursorMoved(scale.xAt(event->position().x()));
    } else {
        emit cursorLeft();
    }
    QWidget::mouseMoveEvent(event);
}

void TimeChart::leaveEvent(QEvent* event) {
    emit cursorLeft();
    QWidget::leaveEvent(event);
}

} // namespace hexapose

#include "moc_time_chart.cpp"
