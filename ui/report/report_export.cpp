// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_export.h"

#include "core/base/input_error.h"
#include "ui/plot/picture_files.h"
#include "ui/report/error_report_pdf.h"
#include "ui/report/report_words.h"

#include <QBuffer>
#include <QDateTime>

#include <system_error>

namespace hexapose {

namespace {

constexpr QSize kPngSize(2000, 1480);
constexpr QSize kSvgSize(1000, 740);
constexpr double kMarginPart = 0.015; ///< of the width, around the panels

void paintFigure(QPainter& painter, const QSize& size, const ErrorReport& report) {
    const QRectF whole(QRect(QPoint(0, 0), size));
    const double margin = kMarginPart * whole.width();
    painter.fillRect(whole, Qt::white);
    paintErrorPanels(painter, whole.adjusted(margin, margin, -margin, -margin), report);
}

QByteArray pdfBytes(const ErrorReport& report) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writeErrorReportPdf(report, QDateTime::currentDateTime(), buffer);
    return buffer.data();
}

/// The figure as both kinds of files.
QByteArray figurePng(const ErrorReport& report) {
    return pngBytes(kPngSize, [&](QPainter& painter) { paintFigure(painter, kPngSize, report); });
}

QByteArray figureSvg(const ErrorReport& report) {
    return svgBytes(kSvgSize, ReportWords::tr("Forward kinematics error report"),
                    QString::fromStdString(report.platformName),
                    [&](QPainter& painter) { paintFigure(painter, kSvgSize, report); });
}

} // namespace

std::vector<std::filesystem::path> exportErrorReport(const ErrorReport& report,
                                                     const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
        throw InputError(directory.string(), "cannot be created: " + error.message());
    const std::vector<std::pair<std::filesystem::path, QByteArray>> files{
        {directory / "report.pdf", pdfBytes(report)},
        {directory / "errors.csv", QByteArray::fromStdString(formatErrorCsv(report))},
        {directory / "errors.png", figurePng(report)},
        {directory / "errors.svg", figureSvg(report)},
    };
    std::vector<std::filesystem::path> written;
    for (const auto& [file, bytes] : files) {
        writeWholeFile(file, bytes);
        written.push_back(file);
    }
    return written;
}

} // namespace hexapose
