// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace hexapose {

/// What a motion is controlled by.
enum class MotionMode {
    Joint,     ///< each leg for itself: set-points on straight leg paths, the pose is only watched
    Workspace, ///< the loop is closed on the pose
};

/// "joint", "workspace": as on the command line and in the log.
std::string_view toWord(MotionMode mode);
std::optional<MotionMode> motionModeFromWord(std::string_view word);

} // namespace hexapose
