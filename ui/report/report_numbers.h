// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/error_report.h"

#include <QString>

namespace hexapose {

/// An error or a bound in three digits: -1.69e-4.
QString errorText(double value);

/// How many decimals the printed report needs, so that the last one is well below what the resolution lets be
/// seen, for a micro-positioner as for a flight simulator. Poses in SI and in the units of the table.
class PoseDecimals {
public:
    explicit PoseDecimals(const ErrorReport& report);
    /// Coordinate 0..5 in the order x y z alpha beta gamma; values in m and rad.
    QString si(int coordinate, double value) const;     ///< m, rad
    QString common(int coordinate, double value) const; ///< mm, deg
    /// The same for an error, in one decimal more; in three digits where that would show nothing of it.
    QString commonError(int coordinate, double value) const;

private:
    int m_metres, m_radians, m_mm, m_degrees;
};

/// A value in m or rad, in the units of the table: mm or degrees.
double commonUnits(int coordinate, double value);

} // namespace hexapose
