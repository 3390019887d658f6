// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/error_report.h"

#include <QImage>
#include <QPainter>
#include <QRectF>

#include <filesystem>
#include <vector>

namespace hexapose {

/// Draws the two panels of Figure 8 (angle errors in rad, displacement errors in m, over the sample number),
/// with the predicted bound as a band, into the rectangle: one above the other, or side by side in a flat
/// one. Always light: it is paper.
void paintErrorPanels(QPainter& painter, const QRectF& area, const ErrorReport& report);

/// Writes report.pdf, errors.csv, errors.png and errors.svg into the directory (made when missing). Each file
/// is written under a temporary name and renamed. Throws InputError when one cannot be written. Returns the
/// paths in this order. Text needs a QGuiApplication; the offscreen platform will do.
std::vector<std::filesystem::path> exportErrorReport(const ErrorReport& report,
                                                     const std::filesystem::path& directory);

} // namespace hexapose
