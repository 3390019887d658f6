// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/status/leg_bar.h"

#include <QPainter>
#include <QPalette>

#include <algorithm>

namespace hexapose {

LegBar::LegBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void LegBar::setStroke(double low, double high) {
    if (low != m_low || high != m_high) {
        m_low = low;
        m_high = high;
        update();
    }
}

void LegBar::setLengths(std::optional<double> measured, std::optional<double> commanded, bool stale) {
    if (measured != m_measured || commanded != m_commanded || stale != m_stale) {
        m_measured = measured;
        m_commanded = commanded;
        m_stale = stale;
        update();
    }
}

double LegBar::part(double length) const {
    return m_high > m_low ? std::clamp((length - m_low) / (m_high - m_low), 0.0, 1.0) : 0.0;
}

void LegBar::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track = QRectF(rect()).adjusted(1.5, 2.5, -1.5, -2.5);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawRoundedRect(track, 3.5, 3.5);
    if (m_measured) {
        QRectF fill = track;
        fill.setWidth(std::max(track.width() * part(*m_measured), 3.0));
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_stale ? palette().color(QPalette::Mid) : palette().color(QPalette::Highlight));
        painter.drawRoundedRect(fill, 3.5, 3.5);
    }
    if (m_commanded) {
        const double x = track.left() + track.width() * part(*m_commanded);
        painter.setPen(QPen(palette().color(QPalette::WindowText), 1.6));
        painter.drawLine(QPointF(x, 0.5), QPointF(x, height() - 0.5));
    }
}

} // namespace hexapose

#include "moc_leg_bar.cpp"
