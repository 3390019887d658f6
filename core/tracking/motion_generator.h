// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/motion/limits.h"
#include "core/motion/motion_mode.h"
#include "core/motion/pose_motion.h"
#include "core/record/event.h"

#include <optional>

namespace hexapose {

/// How close to the end counts as there.
struct SettleWindow {
    double distance = 0.0; ///< m: of each leg in joint mode, of P in workspace mode
    double angle = 0.0;    ///< rad, in workspace mode
};

/// Makes set-points out of one motion, once a cycle. Pure.
class MotionGenerator {
public:
    struct Cycle {
        double seconds = 0.0;              ///< since the last one; a late cycle must not make a leap
        double speed = 1.0;                ///< 0..1: the operator's part of full speed
        std::optional<LegLengths> lengths; ///< fresh measurement, m
        std::optional<Pose> pose;          ///< and its pose
        MotionLimits limits;
    };

    virtual ~MotionGenerator() = default;
    virtual MotionMode mode() const = 0;
    /// The next set-point, m.
    virtual LegLengths step(const Cycle& cycle) = 0;
    virtual bool finished() const = 0;
    /// Whether the platform is at the end of the motion.
    virtual bool inPosition(const LegLengths& lengths, const Pose& pose,
                            const SettleWindow& window) const = 0;
    /// Where the platform should be now; nothing where only the legs are led.
    virtual std::optional<PoseReference> reference() const = 0;
    virtual double duration() const = 0; ///< planned, at full speed, s
    /// It should go on, and has hardly done so for a second.
    virtual bool stalls() const { return false; }
    /// Something to tell since the last call.
    virtual std::optional<Event> takeEvent() { return std::nullopt; }
};

} // namespace hexapose
