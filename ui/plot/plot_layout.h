// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot.h"

namespace hexapose {

/// Where the values of a plot lie.
struct PlotScale {
    QRectF frame;
    AxisRange x;
    AxisRange y;

    QPointF at(double valueX, double valueY) const;
    double xAt(double position) const; ///< the value at a position
    double yAt(double position) const;
};

struct PlotLayout {
    PlotScale scale;
    Ticks xTicks;
    Ticks yTicks;
};

/// Ticks as many as there is room for, and the frame that the text leaves.
PlotLayout layOutPlot(const Plot& plot, const QRectF& area, const PlotStyle& style,
                      const QPaintDevice& device);

/// Room between text and lines, in units.
inline constexpr double kPlotGap = 6.0;

} // namespace hexapose
