// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart_style.h"

#include <QWidget>

namespace hexapose {

namespace {

constexpr double kSmallText = 0.9; // of the screen's own size

} // namespace

PlotStyle chartStyle(const ThemeColors& colors, const QWidget& widget) {
    PlotStyle style;
    style.ground = colors.surface;
    style.text = colors.text;
    style.label = colors.muted;
    style.axis = colors.idle;
    style.grid = colors.border;
    style.titleFont = widget.font();
    style.titleFont.setBold(true);
    style.font = widget.font();
    if (style.font.pointSizeF() > 0.0) {
        style.font.setPointSizeF(style.font.pointSizeF() * kSmallText);
    }
    style.tickFont = style.font;
    style.pixel = 1.0 / widget.devicePixelRatioF();
    style.labelRoom = QStringLiteral("-00");
    style.verticalGrid = true;
    return style;
}

} // namespace hexapose
