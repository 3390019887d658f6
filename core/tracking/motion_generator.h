// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/motion/limits.h"
#include "core/motion/motion_mode.h"
#include "core/motion/pose_motion.h"
#include "core/record/event.h"
#include "core/tracking/settle_window.h"

#include <optional>

namespace hexapose {

/// Makes set-points out of one motion, once a cycle. Pure.
class MotionGenerator {
public:
    struct Cycle {
        double seconds = 0.0;              ///< since the last one; a late cycle must not make a leap
        double speed = 1.0;                ///< 0..1: the operator's speed override
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
    /// An event since the last call, to be reported.
    virtual std::optional<Event> takeEvent() { return std::nullopt; }
};

} // namespace hexapose
