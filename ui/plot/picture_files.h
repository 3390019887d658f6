// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QPainter>
#include <QSize>
#include <QString>

#include <filesystem>
#include <functional>

namespace hexapose {

/// A PNG, or an SVG, of what `paint` draws.
QByteArray pngBytes(const QSize& size, const std::function<void(QPainter&)>& paint);
QByteArray svgBytes(const QSize& size, const QString& title, const QString& description,
                    const std::function<void(QPainter&)>& paint);

/// Under a temporary name first, so that nobody ever sees half of it. Throws InputError when it cannot be
/// written.
void writeWholeFile(const std::filesystem::path& file, const QByteArray& bytes);

} // namespace hexapose
