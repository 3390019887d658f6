// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot.h"

namespace hexapose {

/// Radius of a marker, in units, below which markers and lines are drawn as a crowd.
inline constexpr double kCrowdedMarker = 2.5;
/// Width of a swatch in a legend, in units.
inline constexpr double kSwatchWidth = 24.0;

void paintPlotMarker(QPainter& painter, Plot::Marker marker, const QColor& colour, QPointF centre,
                     double radius, const PlotStyle& style);

/// What stands before the name of a series in a legend; `left` is the middle of its left edge.
void paintSwatch(QPainter& painter, const Plot::Series& series, QPointF left, const PlotStyle& style);

} // namespace hexapose
