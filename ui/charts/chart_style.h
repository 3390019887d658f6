// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/common/theme.h"
#include "ui/plot/plot_style.h"

class QWidget;

namespace hexapose {

/// The plot style of a chart on the screen: the theme's colours, the widget's font and its pixels.
PlotStyle chartStyle(const ThemeColors& colors, const QWidget& widget);

} // namespace hexapose
