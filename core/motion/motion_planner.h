// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/platform_model.h"
#include "core/motion/limits.h"
#include "core/motion/motion_check.h"
#include "core/motion/motion_mode.h"
#include "core/motion/plan_budget.h"
#include "core/motion/pose_motion.h"
#include "core/motion/sine_sweep.h"

#include <memory>
#include <optional>
#include <variant>

namespace hexapose {

/// To a pose: on straight leg paths in joint mode, on a straight line in workspace mode.
struct StraightMove {
    Pose target;
    MotionMode mode = MotionMode::Joint;
};

/// What can be planned. A sweep is about the pose where it starts, in workspace mode.
using MotionRequest = std::variant<StraightMove, SweepSettings>;

/// Where a motion starts.
struct PlanStart {
    LegLengths setPoint = LegLengths::Zero(); ///< in force, m
    Pose pose;                                ///< measured: of P from home, base frame, m and rad
};

/// A motion that was planned and checked whole. A value: nothing changes it afterwards.
struct PlannedMotion {
    MotionCheck check; ///< unless it is ok, what follows the limits means nothing
    MotionRequest request;
    PlanStart start;
    MotionLimits limits;
    MotionBounds bounds;
    double strokeSlack = 0.0;                   ///< m, see planMotion()
    std::shared_ptr<const PoseMotion> motion;   ///< workspace mode; null in joint mode
    LegLengths endLengths = LegLengths::Zero(); ///< at the pose where the motion ends, m
    double duration = 0.0;                      ///< at full speed, s

    MotionMode mode() const;
    /// The target, or the centre of a sweep.
    Pose endPose() const;
    /// Whether it was asked to go to this pose, in this mode.
    bool isFor(const StraightMove& move) const;
};

/// How a plan travels.
using SharedPlan = std::shared_ptr<const PlannedMotion>;

/// Plans and checks a motion. strokeSlack: a leg that starts beyond an end of its stroke by no more than this
/// may be there, m. A plan that takes longer than the budget is refused with PlanTooLong and the fraction of
/// the path that was checked. Deterministic, but for that; may be called from any thread.
PlannedMotion planMotion(const PlatformModel& model, const MotionBounds& bounds, const MotionLimits& limits,
                         double strokeSlack, const PlanStart& start, const MotionRequest& request,
                         const PlanBudget& budget = {});

/// Whether a plan can be begun from here and under these limits: its own check where that is not ok,
/// LimitsChanged where the limits are other ones, StartMoved where a leg's set-point or P is further from the
/// planned start than `distance` (m), or the platform turned by more than `angle` (rad) from it. Takes no
/// longer for a long motion.
MotionCheck checkStart(const PlannedMotion& planned, const PlanStart& now, const MotionLimits& limitsNow,
                       double distance, double angle);

/// Plans and checks the motions of one machine under the limits in force: those of the platform and of the
/// operator, narrowed by the controller's. A screen or a command line that asks beforehand gets the answer
/// that the loop will give.
class MotionPlanner {
public:
    struct Settings {
        MotionBounds bounds; ///< complete, see withDefaults()
        PoseEnvelope envelope;
        double strokeSlack = 0.0; ///< m, see planMotion()
    };
    MotionPlanner(SharedModel model, const Settings& settings);

    void setSettings(const Settings& settings);
    /// Of every leg, m; nothing where the controller has none.
    void setControllerLimits(std::optional<double> minLength, std::optional<double> maxLength);

    const PlatformModel& model() const { return *m_model; }
    const SharedModel& sharedModel() const { return m_model; }
    const Settings& settings() const { return m_settings; }
    const MotionLimits& limits() const { return m_limits; }
    /// Of a motion that begins at this pose.
    MotionLimits limitsAt(const Pose& pose) const;
    MotionCheck check(const Pose& pose) const;
    PlannedMotion plan(const PlanStart& start, const MotionRequest& request,
                       const PlanBudget& budget = {}) const;
    /// From rest at `from`, whose set-point is that of the pose.
    MotionCheck check(const Pose& from, const Pose& to, MotionMode mode) const;

private:
    void applySettings();

    SharedModel m_model;
    Settings m_settings;
    MotionLimits m_limits;
};

} // namespace hexapose
