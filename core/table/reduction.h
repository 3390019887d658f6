// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/column.h"
#include "core/table/time_axis.h"

#include <vector>

namespace hexapose {

/// What is drawn of a curve in one pixel column (M4, Jugel et al., VLDB 2014): first, smallest, largest and
/// last value of its rows, which give the picture that all of them give.
struct PixelColumn {
    int pixel = 0;
    double first = 0.0, min = 0.0, max = 0.0, last = 0.0; ///< numbers: missing cells are passed over
    double firstTime = 0.0, lastTime = 0.0;               ///< s, of first and last
    bool gapBefore = false; ///< the line from the pixel column before is broken: a missing cell or a pause
};

/// The range of time of a view, over so many device pixels.
struct TimeView {
    double begin = 0.0, end = 0.0; ///< s
    int pixels = 0;
};

/// The pixel columns that have a value, from left to right, with the nearest values outside on both sides
/// (pixel -1 and `pixels`), so that lines reach the edges. Of a table whose time goes back, run after run,
/// each begun by a gap. A pause longer than 5 usual steps is a gap.
std::vector<PixelColumn> reduceToPixels(const Column& column, const TimeAxis& time, const TimeView& view);

} // namespace hexapose
