// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/chart_export.h"

#include "core/base/input_error.h"
#include "ui/plot/picture_files.h"
#include "ui/plot/plot_layout.h"
#include "ui/viewer/log_plot.h"
#include "ui/viewer/row_text.h"

#include <QBuffer>
#include <QFile>
#include <QPdfWriter>
#include <QSaveFile>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kPageWidth = 1000.0; // all in units
constexpr double kChartHeight = 230.0;
constexpr double kChartGap = 8.0;
constexpr double kPageMargin = 14.0;
constexpr double kPngScale = 2.0;
constexpr double kColumnsOfUnit = 4.0; ///< a curve on paper may be enlarged
constexpr int kPdfDpi = 300;

std::string kindOf(const std::filesystem::path& file) {
    std::string kind = file.extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter;
    });
    return kind;
}

QSizeF sizeOf(const ChartPicture& picture) {
    const auto charts = static_cast<double>(picture.layout.charts.size());
    return {kPageWidth, 2.0 * kPageMargin + charts * kChartHeight + (charts - 1.0) * kChartGap};
}

/// One below the other, under one left margin; unit: a device pixel, or several.
void paintCharts(QPainter& painter, const QSizeF& size, const ChartPicture& picture, bool hasPixels) {
    const double unit = size.width() / sizeOf(picture).width();
    const PlotStyle style = paperStyle(unit);
    painter.fillRect(QRectF(QPointF(), size), style.ground);
    TableMarks marks;
    marks.follow(*picture.table);
    CurveFinder curves;
    curves.follow(picture.table);
    std::vector<LogPlotSource> sources;
    std::vector<Plot> plots;
    std::vector<QRectF> areas;
    double left = 0.0;
    for (const ChartSpec& chart : picture.layout.charts) {
        const double top = kPageMargin + static_cast<double>(plots.size()) * (kChartHeight + kChartGap);
        areas.emplace_back(kPageMargin * unit, top * unit, (kPageWidth - 2.0 * kPageMargin) * unit,
                           kChartHeight * unit);
        sources.push_back({picture.table, &marks, chart, curves.find(chart), themeColors(ThemeKind::Light),
                           ThemeKind::Light});
        plots.push_back(emptyLogPlot(sources.back(), picture.time, std::nullopt));
        if (plots.size() < picture.layout.charts.size())
            plots.back().xLabel.clear();
        const PlotLayout layout = layOutPlot(plots.back(), areas.back(), style, *painter.device());
        left = std::max(left, layout.scale.frame.left() - areas.back().left());
    }
    for (std::size_t i = 0; i < plots.size(); ++i) {
        plots[i].leastLeft = left;
        const double width = layOutPlot(plots[i], areas[i], style, *painter.device()).scale.frame.width();
        const double columns = hasPixels ? width : width / unit * kColumnsOfUnit;
        fillLogPlot(plots[i], sources[i], picture.time, std::max(1, static_cast<int>(std::lround(columns))));
        paintPlot(painter, areas[i], plots[i], style);
    }
}

QByteArray pdfBytes(const ChartPicture& picture) {
    const QSizeF size = sizeOf(picture);
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(kPdfDpi);
    writer.setTitle(QString::fromStdString(picture.table->sourceName()));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    constexpr double kPageWidthMm = 277.0; // as A4 on its side with margins; as high as the charts need
    writer.setPageSize(
        QPageSize(QSizeF(kPageWidthMm, kPageWidthMm * size.height() / size.width()), QPageSize::Millimeter));
    QPainter painter(&writer);
    paintCharts(painter, QSizeF(writer.width(), writer.width() * size.height() / size.width()), picture,
                false);
    painter.end();
    return buffer.data();
}

void exportRows(const ChartPicture& picture, const std::filesystem::path& file) {
    QSaveFile out(QFile::decodeName(file.c_str()));
    const auto fail = [&] {
        throw InputError(file.string(), "cannot be written: " + out.errorString().toStdString());
    };
    std::error_code ignored;
    if (std::filesystem::equivalent(file, picture.source, ignored))
        throw InputError(file.string(), "is the log itself");
    if (!out.open(QIODevice::WriteOnly))
        fail();
    copyRows(picture.source, *picture.table, picture.time, [&](std::string_view text) {
        if (out.write(text.data(), static_cast<qint64>(text.size())) != static_cast<qint64>(text.size()))
            fail();
    });
    if (!out.commit())
        fail();
}

} // namespace

bool isExportKind(const std::filesystem::path& file) {
    const std::string kind = kindOf(file);
    return kind == ".png" || kind == ".svg" || kind == ".pdf" || kind == ".csv";
}

void exportCharts(const ChartPicture& picture, const std::filesystem::path& file) {
    const std::string kind = kindOf(file);
    const QSizeF size = sizeOf(picture);
    if (kind == ".csv") {
        exportRows(picture, file);
    } else if (kind == ".png") {
        const QSize pixels = (size * kPngScale).toSize();
        writeWholeFile(
            file, pngBytes(pixels, [&](QPainter& painter) { paintCharts(painter, pixels, picture, true); }));
    } else if (kind == ".svg") {
        writeWholeFile(file,
                       svgBytes(size.toSize(), QString::fromStdString(picture.table->sourceName()), QString(),
                                [&](QPainter& painter) { paintCharts(painter, size, picture, false); }));
    } else if (kind == ".pdf") {
        writeWholeFile(file, pdfBytes(picture));
    } else {
        throw InputError(file.string(), "ends in none of .png, .svg, .pdf, .csv");
    }
}

} // namespace hexapose
