// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hexapose {

/// A length (m) in mm and an angle (rad) in degrees, as files hold them: the plainest text that
/// metresFromMm() or radiansFromDeg() turns into the same double again (for the few angles that no double in
/// degrees gives, into its neighbour). Empty for a value that is not finite.
std::string mmText(double metres);
std::string degText(double radians);

} // namespace hexapose
