// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/kinematics/platform_model.h"
#include "core/motion/limits.h"
#include "core/motion/pose_motion.h"
#include "core/tracking/lag_estimator.h"

namespace hexapose {

struct WorkspaceOptions {
    double gain = 8.0;     ///< 1/s: rate of the correction for an error of 1; lower where feedback is rare
    double legSpeed = 0.0; ///< m/s, of each leg, above zero
    /// m, above zero: what a leg is led to goes no further ahead of it; its set-point, with the lead for its
    /// lag, 1.4 times as far.
    double gapLimit = 0.0;
    double speedUpTime = 0.25; ///< s, from a path that was held up to full speed
    /// While the reference stands an error within these is left alone: the legs would only follow the
    /// rounding.
    double restDistance = 0.0; ///< m
    double restAngle = 0.0;    ///< rad
};

/// One step of the loop that is closed on the pose: error against the reference -> twist (feed-forward and
/// gain) -> leg rates by the Jacobian -> set-points. Rates are scaled together, so that the direction in the
/// workspace is kept, and the path is slowed down for the slowest leg. Set-points lead by each leg's own lag,
/// which is learned along the path. Clock, wire and thread know nothing of it.
class WorkspaceController {
public:
    WorkspaceController(SharedModel model, const WorkspaceOptions& options);

    struct Measurement {
        LegLengths lengths; ///< m
        Pose pose;
        double seconds; ///< since the last one
    };
    /// Time: the reference goes on with the clock, and what lags behind catches up. Path: it waits for the
    /// platform, or goes on with it, so that the speed along the path is the planned one.
    enum class Following { Time, Path };
    struct Step {
        LegLengths setPoint; ///< m
        double pathRate;     ///< of the reference's own speed; the caller moves it on by rate * seconds
        Twist error;         ///< from the measured pose to the reference, m and rad
        bool saturated;      ///< a leg's speed, stroke or gap held the motion back
    };

    /// A motion begins, or goes on after other set-points: from the one in force.
    void begin(const LegLengths& setPoint);
    /// wantedRate: 0..1, the operator's.
    Step step(const Measurement& measured, const PoseReference& reference, Following following,
              double wantedRate, const MotionLimits& limits);

    const LegLengths& lags() const { return m_lagEstimator.lags(); } ///< s

private:
    double lagOf(const Twist& error, const Twist& twist) const;
    void driftToRest(const LegLengths& end, double seconds);
    double allowedRate(const LegLengths& feedForward, const LegLengths& correction) const;

    SharedModel m_model;
    WorkspaceOptions m_options;
    LegLagEstimator m_lagEstimator;
    LegLengths m_aim = LegLengths::Zero();      ///< where the legs should be: the integral of their rates
    LegLengths m_setPoint = LegLengths::Zero(); ///< the last one
    double m_pathRate = 0.0;
};

} // namespace hexapose
