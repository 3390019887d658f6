// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/motion_check.h"
#include "core/motion/sine_sweep.h"

#include <optional>
#include <string>
#include <string_view>

namespace hexapose {

/// Short stable words, as in the log and in the command line's contract: "ok", "leg 3 above max_mm", "leg 2
/// below min_mm", "invalid-input", "near singular", "other branch", "path near singular at 63 %", "alpha
/// outside the envelope", "leg 4 too fast at 12 %".
std::string toWords(const MotionCheck& check);
/// What can be read from those words: value and bound are NaN, the fraction is in whole per cent.
std::optional<MotionCheck> motionCheckFromWords(std::string_view words);

/// "sweep: the amplitude is not above zero".
std::string_view toWords(SweepFault fault);
std::optional<SweepFault> sweepFaultFromWords(std::string_view words);

} // namespace hexapose
