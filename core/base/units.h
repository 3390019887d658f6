// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

/// Conversions at the borders of the program. Inside, everything is SI: metres, radians, seconds. Any double
/// will do.
namespace hexapose {

/// Division rather than a factor of 1e-3: 339.5 mm becomes the double nearest to 0.3395 m.
constexpr double metresFromMm(double mm) {
    return mm / 1000.0;
}
constexpr double mmFromMetres(double metres) {
    return metres * 1000.0;
}
constexpr double radiansFromDeg(double deg) {
    return deg * std::numbers::pi / 180.0;
}
constexpr double degFromRadians(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

} // namespace hexapose
