// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QString>

namespace hexapose {

/// How a plot looks on a screen or on paper.
struct PlotStyle {
    QColor ground; ///< under the curves
    QColor text;   ///< title, legend and note
    QColor label;  ///< numbers and titles of the axes
    QColor axis;
    QColor grid;
    QFont font;
    QFont tickFont;
    QFont titleFont;
    double unit = 1.0;  ///< size of everything that is neither data nor text; 1 gives lines of about 1 px
    double pixel = 0.0; ///< size of a pixel, to which frame and grid keep; 0 where there are none
    QString labelRoom;  ///< what the numbers beside a frame have room for at least, so that plots line up
    bool verticalGrid = false;

    double onPixel(double position) const; ///< the middle of its pixel, where a line is sharp
    double column() const; ///< in which a curve shows no more than its smallest and its largest value
};

/// Always light. Text has 13 px at unit 1.
PlotStyle paperStyle(double unit);

/// The face of all printed text, at a size in pixels of the device.
QFont paperFont(double pixels, bool bold = false);

} // namespace hexapose
