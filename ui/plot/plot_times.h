// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_layout.h"

namespace hexapose {

/// The spans of a plot, under its grid.
void paintSpans(QPainter& painter, const Plot& plot, const PlotLayout& layout, const PlotStyle& style);
/// Its instants, under its curves.
void paintInstants(QPainter& painter, const Plot& plot, const PlotLayout& layout, const PlotStyle& style);

} // namespace hexapose
