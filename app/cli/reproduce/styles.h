// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot.h"

#include <cstdint>

namespace hexapose::reproduce {

enum class Kind : std::uint8_t { Published, Measured, Exact };

/// How each kind of value is drawn: a ring on paper's word, a dot in it where the measurement agrees.
Plot::Series seriesOf(Kind kind, bool connected);

// Of the Okabe-Ito colours, which stay apart in colour-blind eyes and in grey.
inline const QColor kBlack(0x22, 0x22, 0x22);
inline const QColor kBlue(0x00, 0x72, 0xB2);
inline const QColor kVermilion(0xD5, 0x5E, 0x00);
inline const QColor kGreen(0x00, 0x9E, 0x73);

/// The range of all points of some series, and a part of it more on both sides.
AxisRange rangeOf(const std::vector<Plot::Series>& series, double headroom);

} // namespace hexapose::reproduce
