// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hexapose {

/// A length (m) in mm and an angle (rad) in degrees, as files hold them: the plainest text that
/// metresFromMm() or radiansFromDeg() turns into the same double again, or into its neighbour where no double
/// in mm or degrees gives the very same. Empty for a value that is not finite.
std::string mmText(double metres);
std::string degText(double radians);

} // namespace hexapose
