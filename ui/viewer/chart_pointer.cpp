// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart_style.h"
#include "ui/viewer/cursor_numbers.h"
#include "ui/viewer/log_chart.h"
#include "ui/viewer/qt_text.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

// What a chart tells beside the pointer; log_chart.cpp is the rest of it.
namespace hexapose {

namespace {

constexpr int kPointerDigits = 8;
constexpr double kPointerGap = 6.0; // pixels

} // namespace

void LogChart::setPointer(std::optional<double> time) {
    if (time != m_shown)
        update();
    m_shown = time;
}

QStringList LogChart::pointerText() const {
    QStringList lines;
    if (!m_shown)
        return lines;
    const QString unit = m_source.table->time().hasTime() ? QStringLiteral(" s") : QString();
    lines.append(QString::number(*m_shown, 'g', kPointerDigits) + unit);
    for (const Curve& curve : m_source.curves) {
        const auto value = valueAt(*m_source.table, *curve.column, *m_shown);
        const ColumnInfo& info = curve.column->info();
        lines.append(toQt(info.label) + QStringLiteral("  ") +
                     (value ? QString::number(*value, 'g', kPointerDigits) : QStringLiteral("--")));
    }
    return lines;
}

/// A line in every chart, the numbers in the one under the pointer.
void LogChart::paintPointer(QPainter& painter, const PlotScale& scale) const {
    const PlotStyle style = chartStyle(m_source.colors, *this);
    const QRectF& frame = scale.frame;
    const double x = style.onPixel(scale.at(*m_shown, 0.0).x());
    if (x < frame.left() || x > frame.right())
        return;
    painter.setPen(QPen(style.label, 1.0, Qt::DotLine));
    painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
    if (!m_pointer)
        return;
    const QFontMetricsF metrics(style.font, this);
    const QStringList lines = pointerText();
    QString text = lines.join(QLatin1Char('\n'));
    if (static_cast<double>(lines.size()) * metrics.lineSpacing() > frame.height())
        text = metrics.elidedText(lines.join(QStringLiteral("   ")), Qt::ElideRight,
                                  frame.width() - 4.0 * kPointerGap);
    const QSizeF size = metrics.size(0, text) + QSizeF(2.0 * kPointerGap, kPointerGap);
    // Beside the line, on the side where there is room.
    double left = x + kPointerGap;
    if (left + size.width() > frame.right())
        left = std::max(x - kPointerGap - size.width(), frame.left());
    const QRectF box(QPointF(left, frame.top() + 2.0), size);
    painter.setFont(style.font);
    painter.setPen(QPen(style.label, style.pixel));
    painter.setBrush(style.ground);
    painter.drawRoundedRect(box, 3.0, 3.0);
    painter.setPen(style.text);
    painter.drawText(box.adjusted(kPointerGap, 0.0, -kPointerGap, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                     text);
}

} // namespace hexapose
