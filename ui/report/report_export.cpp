// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_export.h"

#include "core/geometry/input_error.h"
#include "ui/report/error_report_pdf.h"

#include <QBuffer>
#include <QDateTime>
#include <QFile>
#include <QImage>
#include <QSaveFile>
#include <QSvgGenerator>

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

QByteArray pngBytes(const ErrorReport& report) {
    QImage image(kPngSize, QImage::Format_RGB32);
    QPainter painter(&image);
    paintFigure(painter, image.size(), report);
    painter.end();
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return buffer.data();
}

QByteArray svgBytes(const ErrorReport& report) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(kSvgSize);
    generator.setViewBox(QRect(QPoint(), kSvgSize));
    generator.setTitle(QStringLiteral("Forward kinematics error report"));
    generator.setDescription(QString::fromStdString(report.platformName).toHtmlEscaped());
    QPainter painter(&generator);
    paintFigure(painter, kSvgSize, report);
    painter.end();
    return buffer.data();
}

/// Under a temporary name first, so that nobody ever sees half of it.
void writeWhole(const std::filesystem::path& file, const QByteArray& bytes) {
    QSaveFile out(QFile::decodeName(file.c_str()));
    if (bytes.isEmpty() || !out.open(QIODevice::WriteOnly) || out.write(bytes) != bytes.size() ||
        !out.commit())
        throw InputError(file.string(), "cannot be written: " + out.errorString().toStdString());
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
        {directory / "errors.png", pngBytes(report)},
        {directory / "errors.svg", svgBytes(report)},
    };
    std::vector<std::filesystem::path> written;
    for (const auto& [file, bytes] : files) {
        writeWhole(file, bytes);
        written.push_back(file);
    }
    return written;
}

void exportErrorPictures(const ErrorReport& report, const std::filesystem::path& stem) {
    writeWhole(stem.string() + ".png", pngBytes(report));
    writeWhole(stem.string() + ".svg", svgBytes(report));
}

} // namespace hexapose
