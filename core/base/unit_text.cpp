// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/unit_text.h"

#include "core/base/number_text.h"
#include "core/base/units.h"

#include <cmath>

namespace hexapose {

namespace {

/// 0.3395 m is 339.49999999999994 mm in doubles; the plain 339.5 reads back to 0.3395 just as well.
template <typename ToSi>
std::string shortest(double si, double scaled, ToSi toSi) {
    if (!std::isfinite(scaled))
        return {};
    constexpr double kPlainSteps = 1e6;
    const double plain = std::round(scaled * kPlainSteps) / kPlainSteps;
    if (toSi(plain) == si)
        return formatNumber(plain);
    // The conversion rounds; the double that reads back exactly may be the neighbour.
    for (const double candidate : {scaled, std::nextafter(scaled, 0.0), std::nextafter(scaled, 2.0 * scaled)})
        if (toSi(candidate) == si)
            return formatNumber(candidate);
    return formatNumber(scaled);
}

} // namespace

std::string mmText(double metres) {
    return shortest(metres, mmFromMetres(metres), metresFromMm);
}

std::string degText(double radians) {
    return shortest(radians, degFromRadians(radians), radiansFromDeg);
}

} // namespace hexapose
