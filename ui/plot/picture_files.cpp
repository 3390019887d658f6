// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/picture_files.h"

#include "core/base/input_error.h"

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QSaveFile>
#include <QSvgGenerator>

namespace hexapose {

QByteArray pngBytes(const QSize& size, const std::function<void(QPainter&)>& paint) {
    QImage image(size, QImage::Format_RGB32);
    QPainter painter(&image);
    paint(painter);
    painter.end();
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return buffer.data();
}

QByteArray svgBytes(const QSize& size, const QString& title, const QString& description,
                    const std::function<void(QPainter&)>& paint) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(title);
    generator.setDescription(description.toHtmlEscaped());
    QPainter painter(&generator);
    paint(painter);
    painter.end();
    return buffer.data();
}

void writeWholeFile(const std::filesystem::path& file, const QByteArray& bytes) {
    QSaveFile out(QFile::decodeName(file.c_str()));
    if (bytes.isEmpty() || !out.open(QIODevice::WriteOnly) || out.write(bytes) != bytes.size() ||
        !out.commit())
        throw InputError(file.string(), "cannot be written: " + out.errorString().toStdString());
}

} // namespace hexapose
