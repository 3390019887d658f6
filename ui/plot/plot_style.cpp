// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/plot_style.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kTextSize = 13.0; // in units
constexpr double kTickTextSize = 12.0;
constexpr double kScreenColumn = 1.0; ///< a pixel, or several that a curve's width covers
constexpr double kPaperColumn = 0.25; ///< may be enlarged

} // namespace

double PlotStyle::onPixel(double position) const {
    return pixel > 0.0 ? (std::floor(position / pixel) + 0.5) * pixel : position;
}

double PlotStyle::column() const {
    return (pixel > 0.0 ? kScreenColumn : kPaperColumn) * unit;
}

PlotStyle paperStyle(double unit) {
    PlotStyle style;
    style.ground = Qt::white;
    style.text = QColor(0x22, 0x22, 0x22);
    style.label = style.text;
    style.axis = QColor(0x80, 0x80, 0x80);
    style.grid = QColor(0xD8, 0xD8, 0xD8);
    style.font = paperFont(kTextSize * unit);
    style.tickFont = paperFont(kTickTextSize * unit);
    style.titleFont = paperFont(kTextSize * unit, true);
    style.unit = unit;
    style.labelRoom = QStringLiteral("-0.00");
    return style;
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
