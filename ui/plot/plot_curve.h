// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_layout.h"

#include <QPen>
#include <QPolygonF>

namespace hexapose {

/// A curve as it is drawn: each piece is unbroken.
using CurvePieces = std::vector<QPolygonF>;

/// The curve on the device. It is broken where a value is not finite; of the points in one column of that
/// width only the smallest and the largest are left, in their order, so that no peak is lost and a million
/// points are as quick as a thousand.
CurvePieces curvePieces(const std::vector<QPointF>& points, const PlotScale& scale, double column);

/// The same, of points that are reduced already: all that can be told apart on the device.
CurvePieces wholePieces(const std::vector<QPointF>& points, const PlotScale& scale);

/// Across and down together, as far as it matters whether it is longer than that.
double curveLength(const CurvePieces& pieces, double most);

/// A single point between two gaps is a dot.
void paintCurve(QPainter& painter, const CurvePieces& pieces, const QPen& pen);

} // namespace hexapose
