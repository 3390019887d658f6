// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/picture.h"

#include "ui/plot/picture_files.h"
#include "ui/plot/plot_marks.h"

#include <QFontMetricsF>

#include <algorithm>

namespace hexapose {

namespace {

constexpr double kPictureMargin = 12.0; // all sizes in units
constexpr double kPanelGap = 14.0;
constexpr double kLegendHeight = 30.0;
constexpr double kLegendSpace = 6.0;
constexpr double kPngScale = 2.0;

int rowsOf(const Picture& picture) {
    return (static_cast<int>(picture.plots.size()) + picture.columns - 1) / picture.columns;
}

/// One line, from the left.
void paintLegend(QPainter& painter, QPointF corner, const Picture& picture, const PlotStyle& style) {
    const double unit = style.unit;
    const QFontMetricsF metrics(style.font, painter.device());
    painter.setFont(style.font);
    QPointF at = corner + QPointF(0.0, kLegendHeight / 2.0 * unit);
    for (const Plot::Series& series : picture.legend) {
        paintSwatch(painter, series, at, style);
        at.rx() += (kSwatchWidth + kLegendSpace) * unit;
        const double width = metrics.horizontalAdvance(series.name) + kLegendSpace * unit;
        painter.setPen(style.text);
        painter.drawText(QRectF(at.x(), at.y() - metrics.height(), width, 2.0 * metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, series.name);
        at.rx() += width + 2.0 * kLegendSpace * unit;
    }
}

} // namespace

QSizeF Picture::size() const {
    const int rows = rowsOf(*this);
    const double legendHeight = legend.empty() ? 0.0 : kLegendHeight;
    return {2.0 * kPictureMargin + columns * panel.width() + (columns - 1) * kPanelGap,
            2.0 * kPictureMargin + legendHeight + rows * panel.height() + (rows - 1) * kPanelGap};
}

void paintPicture(QPainter& painter, const QRectF& area, const Picture& picture) {
    const QSizeF natural = picture.size();
    const double unit = std::min(area.width() / natural.width(), area.height() / natural.height());
    const PlotStyle style = paperStyle(unit);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::TextAntialiasing);
    painter.fillRect(area, style.ground);
    QPointF corner = area.topLeft() + QPointF(kPictureMargin, kPictureMargin) * unit;
    if (!picture.legend.empty()) {
        paintLegend(painter, corner, picture, style);
        corner.ry() += kLegendHeight * unit;
    }
    const QSizeF step = picture.panel + QSizeF(kPanelGap, kPanelGap);
    for (int i = 0; i < static_cast<int>(picture.plots.size()); ++i) {
        const int row = i / picture.columns, column = i % picture.columns;
        const QPointF cell(step.width() * column, step.height() * row);
        paintPlot(painter, QRectF(corner + cell * unit, picture.panel * unit),
                  picture.plots[static_cast<std::size_t>(i)], style);
    }
    painter.restore();
}

void savePicture(const Picture& picture, const std::filesystem::path& stem) {
    const QSize vector = picture.size().toSize();
    const QSize pixels = (picture.size() * kPngScale).toSize();
    writeWholeFile(stem.string() + ".png", pngBytes(pixels, [&](QPainter& painter) {
                       paintPicture(painter, QRectF(QPointF(), pixels), picture);
                   }));
    writeWholeFile(stem.string() + ".svg", svgBytes(vector, picture.title, QString(), [&](QPainter& painter) {
                       paintPicture(painter, QRectF(QPointF(), vector), picture);
                   }));
}

} // namespace hexapose
