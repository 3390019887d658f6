// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/motion_mode.h"

namespace hexapose {

std::string_view toWord(MotionMode mode) {
    return mode == MotionMode::Joint ? "joint" : "workspace";
}

std::optional<MotionMode> motionModeFromWord(std::string_view word) {
    if (word == "joint")
        return MotionMode::Joint;
    if (word == "workspace")
        return MotionMode::Workspace;
    return std::nullopt;
}

} // namespace hexapose
