// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/time_chart.h"

#include "core/base/number_text.h"
#include "ui/charts/curve_item.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QMouseEvent>
#include <QValueAxis>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kSmallText = 0.9; // of the screen's own size

QValueAxis* makeAxis(QChart& chart, QLineSeries& series, Qt::Alignment side) {
    auto* axis = new QValueAxis;
    axis->setTickType(QValueAxis::TicksDynamic);
    axis->setTickAnchor(0.0);
    chart.addAxis(axis, side);
    series.attachAxis(axis);
    return axis;
}

QString cursorNumber(double value, int decimals) {
    return std::isfinite(value) ? QString::fromStdString(formatFixed(value, decimals)) : QStringLiteral("--");
}

} // namespace

TimeChart::TimeChart(QWidget* parent) : QChartView(new QChart, parent) {
    chart()->legend()->hide();
    chart()->setMargins({0, 0, 4, 0});
    chart()->layout()->setContentsMargins(0, 0, 0, 0);
    chart()->setBackgroundRoundness(8.0);
    chart()->setLocalizeNumbers(false);
    auto* scales = new QLineSeries; // only so that the axes have something to belong to
    chart()->addSeries(scales);
    m_time = makeAxis(*chart(), *scales, Qt::AlignBottom);
    m_value = makeAxis(*chart(), *scales, Qt::AlignLeft);
    m_curves = new CurveItem(chart());
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * kSmallText);
    for (QValueAxis* axis : {m_time, m_value}) {
        axis->setLabelsFont(small);
        axis->setTitleFont(small);
    }
    QFont title = font();
    title.setBold(true);
    chart()->setTitleFont(title);
    setFrameShape(QFrame::NoFrame);
    setBackgroundBrush(Qt::NoBrush);
    setStyleSheet(QStringLiteral("background: transparent;"));
    setMouseTracking(true);
    setMinimumSize(200, 130);
    connect(chart(), &QChart::plotAreaChanged, this, [this](const QRectF& area) { m_curves->setArea(area); });
    setSubject({});
}

TimeChart::~TimeChart() = default;

void TimeChart::setSubject(const ChartSubject& subject) {
    m_subject = subject;
    m_range = {};
    chart()->setTitle(subject.title);
    m_value->setTitleText(subject.unit);
    setAccessibleName(subject.title);
}

void TimeChart::setTimeTitle(const QString& title) {
    m_time->setTitleText(title);
}

void TimeChart::setColors(const ThemeColors& colors) {
    m_measuredColor = colors.accent;
    m_targetColor = colors.muted;
    chart()->setBackgroundBrush(colors.surface);
    chart()->setBackgroundPen(QPen(colors.border));
    chart()->setTitleBrush(colors.text);
    for (QValueAxis* axis : {m_time, m_value}) {
        axis->setLabelsColor(colors.muted);
        axis->setTitleBrush(colors.muted);
        axis->setGridLinePen(QPen(colors.border, 0.0));
        axis->setLinePen(QPen(colors.border));
    }
    m_curves->setCursorColors(colors.muted, colors.text, colors.surface);
}

void TimeChart::showWindow(const ChartHistory& history, double from, double to) {
    auto reach = history.range(m_subject.measured, from, to);
    if (m_subject.target) {
        if (const auto target = history.range(*m_subject.target, from, to)) {
            reach = reach ? std::pair(std::min(reach->first, target->first),
                                      std::max(reach->second, target->second))
                          : *target;
        }
    }
    const AxisRange range = chartRange(m_subject.low, m_subject.high, reach);
    if (!(range == m_range)) {
        m_range = range;
        m_value->setTickInterval(range.tick);
        m_value->setLabelFormat(QStringLiteral("%.%1f").arg(tickDecimals(range.tick)));
        m_value->setRange(range.low, range.high);
    }
    const double tick = niceStep((to - from) / 5.0);
    m_time->setTickInterval(tick);
    m_time->setLabelFormat(QStringLiteral("%.%1f").arg(tickDecimals(tick)));
    m_time->setRange(from, to);
    std::vector<CurveItem::Curve> curves;
    if (m_subject.target) {
        curves.push_back(
            {history.curve(*m_subject.target, from, to), QPen(m_targetColor, 1.4, Qt::DashLine)});
    }
    curves.push_back({history.curve(m_subject.measured, from, to), QPen(m_measuredColor, 1.6)});
    m_curves->setWindow(from, to, m_range);
    m_curves->setCurves(std::move(curves));
}

void TimeChart::showCursor(const ChartHistory& history, std::optional<double> time) {
    if (!time) {
        m_curves->setCursor({});
        return;
    }
    QString text = cursorNumber(*time, 2) + QStringLiteral(" s   ") +
                   cursorNumber(history.valueAt(m_subject.measured, *time), m_subject.decimals);
    if (m_subject.target) {
        text += QStringLiteral(" / ") +
                cursorNumber(history.valueAt(*m_subject.target, *time), m_subject.decimals);
    }
    m_curves->setCursor(CurveItem::Cursor{*time, text + QLatin1Char(' ') + m_subject.unit});
}

void TimeChart::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps != 0.0) {
        emit zoomed(std::pow(0.8, steps));
    }
    event->accept();
}

void TimeChart::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = chart()->mapFromScene(mapToScene(event->pos()));
    if (chart()->plotArea().contains(at)) {
        emit cursorMoved(m_curves->timeAt(at.x()));
    } else {
        emit cursorLeft();
    }
    QChartView::mouseMoveEvent(event);
}

void TimeChart::leaveEvent(QEvent* event) {
    emit cursorLeft();
    QChartView::leaveEvent(event);
}

void TimeChart::resizeEvent(QResizeEvent* event) {
    QChartView::resizeEvent(event);
    m_curves->setArea(chart()->plotArea());
}

} // namespace hexapose

#include "moc_time_chart.cpp"
