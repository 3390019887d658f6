// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/status/singularity_bar.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <algorithm>

namespace hexapose {

namespace {

constexpr int kDarkBelow = 128; // lightness of a window
constexpr double kFootHeight = 3.0;

QColor zoneColor(const ThemeColors& colors, Tone tone) {
    return tone == Tone::Bad ? colors.bad : tone == Tone::Warn ? colors.warn : colors.accent;
}

} // namespace

Tone toneOfQ(std::optional<double> q) {
    if (!q) {
        return Tone::Idle;
    }
    return !(*q >= kDangerQ) ? Tone::Bad : *q < kCautionQ ? Tone::Warn : Tone::Good;
}

SingularityBar::SingularityBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SingularityBar::setValue(std::optional<double> q, bool stale) {
    if (q != m_q || stale != m_stale) {
        m_q = q;
        m_stale = stale;
        update();
    }
}

void SingularityBar::paintEvent(QPaintEvent* /*event*/) {
    const ThemeColors colors = themeColors(
        palette().color(QPalette::Window).lightness() < kDarkBelow ? ThemeKind::Dark : ThemeKind::Light);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track = QRectF(rect()).adjusted(1.5, 2.5, -1.5, -2.5);
    QPainterPath outline;
    outline.addRoundedRect(track, 3.5, 3.5);
    painter.fillPath(outline, colors.window);
    painter.save();
    painter.setClipPath(outline);
    const auto zone = [&](double from, double to, QColor color, float strength) {
        color.setAlphaF(strength);
        painter.fillRect(QRectF(track.left() + from * track.width(), track.top(), (to - from) * track.width(),
                                track.height()),
                         color);
    };
    constexpr float kFaint = 0.35F;
    zone(0.0, kDangerQ, colors.bad, kFaint);
    zone(kDangerQ, kCautionQ, colors.warn, kFaint);
    if (m_q) {
        zone(0.0, std::clamp(*m_q, 0.015, 1.0), m_stale ? colors.idle : zoneColor(colors, toneOfQ(m_q)),
             1.0F);
    }
    // The zones stay in sight under a full bar.
    const QRectF foot(track.left(), track.bottom() - kFootHeight, track.width(), kFootHeight);
    painter.fillRect(QRectF(foot.topLeft(), QSizeF(foot.width() * kCautionQ, kFootHeight)), colors.warn);
    painter.fillRect(QRectF(foot.topLeft(), QSizeF(foot.width() * kDangerQ, kFootHeight)), colors.bad);
    painter.restore();
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.drawPath(outline);
    for (const auto& [bound, color] : {std::pair(kDangerQ, colors.bad), std::pair(kCautionQ, colors.warn)}) {
        const double x = track.left() + track.width() * bound;
        painter.setPen(QPen(color, 1.6));
        painter.drawLine(QPointF(x, 0.5), QPointF(x, height() - 0.5));
    }
}

} // namespace hexapose

#include "moc_singularity_bar.cpp"
