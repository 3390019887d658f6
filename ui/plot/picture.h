// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot.h"

#include <filesystem>

namespace hexapose {

/// Plots of one size in rows and columns, under one legend. All sizes in units.
struct Picture {
    QString title; ///< for those who cannot see it
    int columns = 1;
    QSizeF panel{900.0, 330.0};
    std::vector<Plot> plots;
    std::vector<Plot::Series> legend; ///< only name, colour, marker and connected count

    QSizeF size() const; ///< of the whole; a unit is a pixel there
};

/// Into the rectangle, as large as fits, from its top left corner. Always light: it is paper.
void paintPicture(QPainter& painter, const QRectF& area, const Picture& picture);

/// `stem`.png and `stem`.svg. Throws InputError when one cannot be written.
void savePicture(const Picture& picture, const std::filesystem::path& stem);

} // namespace hexapose
