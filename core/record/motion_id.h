// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace hexapose {

/// Distinguishes one commanded motion from another. Whoever commands it chooses the number; 0 is nobody's.
using MotionId = std::uint64_t;
inline constexpr MotionId kNoMotion = 0;

} // namespace hexapose
