// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hexapose {

/// How close to the end of a motion counts as in position.
struct SettleWindow {
    double distance = 0.0; ///< m: of each leg in joint mode, of P in workspace mode
    double angle = 0.0;    ///< rad, in workspace mode
};

} // namespace hexapose
