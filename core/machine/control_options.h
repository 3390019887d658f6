// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/motion/limits.h"
#include "core/motion/motion_planner.h"
#include "core/motion/pose_motion.h"
#include "core/tracking/settle_window.h"

#include <chrono>

namespace hexapose {

/// What the control loop works with. 0 where a length, an angle or a bound stands: see withDefaults().
struct ControlOptions {
    MotionBounds bounds;
    double gain = 8.0;     ///< 1/s, of the loop that is closed on the pose
    PoseEnvelope envelope; ///< furthest from home
    /// Largest error that counts as in position; 0: 0.2 mm, less for tiny strokes, and as much at the joints.
    SettleWindow settleWindow;
    double followingLimit = 0.0; ///< m, a leg further than this from its set-point stops; 0: of the size
    std::chrono::milliseconds echoWithin{300}; ///< set-points that go unaccepted for so long stop
    /// Of the path's time in a cycle; ordinary ones take 15 at most.
    std::chrono::milliseconds longestPathStep{30};
    std::chrono::milliseconds jogHold{200};    ///< a jog stops unless it is repeated within this time
    std::chrono::milliseconds settleTime{300}; ///< inside the window for so long
    std::chrono::milliseconds settleTimeout{10000};
    std::chrono::milliseconds staleAfter{200};     ///< at least; three feedback periods when those are longer
    std::chrono::milliseconds enableTimeout{5000}; ///< for the enabling before a move
    std::chrono::milliseconds referenceTimeout{120000}; ///< for the referencing before a move
};

/// The options with what is not given derived from the machine: bounds, settle window, following limit.
ControlOptions withDefaults(ControlOptions options, const PlatformGeometry& geometry);

/// What the loop plans with under these options, completed by withDefaults().
MotionPlanner::Settings plannerSettings(const ControlOptions& options, const PlatformGeometry& geometry);

} // namespace hexapose
