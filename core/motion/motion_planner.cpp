// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/motion_planner.h"

#include "core/geometry/twist.h"
#include "core/motion/leg_path_check.h"
#include "core/motion/leg_trajectory.h"
#include "core/motion/pose_motion_check.h"
#include "core/motion/straight_motion.h"

#include <chrono>
#include <cmath>
#include <utility>

namespace hexapose {

namespace {

MotionCheck failed(MotionCheck::Reason reason, double value = 0.0, double bound = 0.0) {
    MotionCheck check;
    check.reason = reason;
    check.value = value;
    check.bound = bound;
    return check;
}

/// The motion of a request in the workspace, or nothing when the time is up.
std::shared_ptr<const PoseMotion> makeMotion(const PlatformModel& model, const MotionBounds& bounds,
                                             const Pose& from, const MotionRequest& request,
                                             PlanTimer& timer) {
    if (const auto* sweep = std::get_if<SweepSettings>(&request))
        return std::make_shared<SineSweep>(from, *sweep);
    const auto& move = std::get<StraightMove>(request);
    if (auto motion = StraightMotion::plan(model, from, move.target, bounds, timer))
        return std::make_shared<StraightMotion>(std::move(*motion));
    return nullptr;
}

void planJointMotion(PlannedMotion& planned, const PlatformModel& model, const MotionBounds& bounds,
                     const Pose& target, PlanTimer& timer) {
    planned.check = checkLegPath(model, planned.limits, planned.start.pose, target, &timer);
    if (!planned.check.ok())
        return;
    planned.endLengths = model.actuators(target);
    const LegTrajectory trajectory(planned.start.setPoint, planned.endLengths, bounds.legSpeed);
    planned.duration = std::chrono::duration<double>(trajectory.duration()).count();
}

void planWorkspaceMotion(PlannedMotion& planned, const PlatformModel& model, const MotionBounds& bounds,
                         double strokeSlack, PlanTimer& timer) {
    planned.motion = makeMotion(model, bounds, planned.start.pose, planned.request, timer);
    if (!planned.motion) {
        planned.check = failed(MotionCheck::Reason::PlanTooLong);
        planned.check.fraction = 0.0;
        return;
    }
    const MotionLimits along = limitsFrom(planned.limits, model.actuators(planned.start.pose), strokeSlack);
    planned.check = checkMotion(model, along, *planned.motion, &timer);
    planned.endLengths = model.actuators(planned.endPose());
    planned.duration = planned.motion->duration();
}

} // namespace

MotionMode PlannedMotion::mode() const {
    const auto* move = std::get_if<StraightMove>(&request);
    return move ? move->mode : MotionMode::Workspace;
}

Pose PlannedMotion::endPose() const {
    const auto* move = std::get_if<StraightMove>(&request);
    return move ? move->target : start.pose;
}

bool PlannedMotion::isFor(const StraightMove& move) const {
    const auto* planned = std::get_if<StraightMove>(&request);
    return planned && planned->mode == move.mode && planned->target.toVector() == move.target.toVector();
}

PlannedMotion planMotion(const PlatformModel& model, const MotionBounds& bounds, const MotionLimits& limits,
                         double strokeSlack, const PlanStart& start, const MotionRequest& request,
                         const PlanBudget& budget) {
    PlannedMotion planned;
    planned.request = request;
    planned.start = start;
    planned.limits = limits;
    planned.bounds = bounds;
    planned.strokeSlack = strokeSlack;
    const auto* move = std::get_if<StraightMove>(&request);
    const auto* sweep = std::get_if<SweepSettings>(&request);
    if (move) { // a target that cannot be is not worth a plan
        planned.check = checkPose(model, limits, move->target);
        if (!planned.check.ok())
            return planned;
    }
    if (!start.pose.isFinite() || !start.setPoint.allFinite() || (sweep && faultOf(*sweep))) {
        planned.check = failed(MotionCheck::Reason::NotFinite);
        return planned;
    }
    PlanTimer timer(budget);
    if (planned.mode() == MotionMode::Joint)
        planJointMotion(planned, model, bounds, move->target, timer);
    else
        planWorkspaceMotion(planned, model, bounds, strokeSlack, timer);
    return planned;
}

MotionCheck checkStart(const PlannedMotion& planned, const PlanStart& now, const MotionLimits& limitsNow,
                       double distance, double angle) {
    if (!planned.check.ok())
        return planned.check;
    if (!(planned.limits == limitsNow))
        return failed(MotionCheck::Reason::LimitsChanged);
    int leg = 0;
    const double legMoved = (now.setPoint - planned.start.setPoint).cwiseAbs().maxCoeff(&leg);
    if (!(legMoved <= distance)) {
        MotionCheck check = failed(MotionCheck::Reason::StartMoved, legMoved, distance);
        check.leg = leg + 1;
        return check;
    }
    const Twist moved = displacement(planned.start.pose, now.pose);
    if (const double shift = moved.head<3>().norm(); !(shift <= distance))
        return failed(MotionCheck::Reason::StartMoved, shift, distance);
    if (const double turn = moved.tail<3>().norm(); !(turn <= angle))
        return failed(MotionCheck::Reason::StartMoved, turn, angle);
    return {};
}

MotionPlanner::MotionPlanner(SharedModel model, const Settings& settings)
    : m_model(std::move(model)), m_settings(settings), m_limits(motionLimits(m_model->geometry(), {}, {})) {
    applySettings();
}

void MotionPlanner::setSettings(const Settings& settings) {
    m_settings = settings;
    applySettings();
}

void MotionPlanner::setControllerLimits(std::optional<double> minLength, std::optional<double> maxLength) {
    m_limits = motionLimits(m_model->geometry(), minLength, maxLength);
    applySettings();
}

void MotionPlanner::applySettings() {
    m_limits.envelope = m_settings.envelope;
    m_limits.legSpeed = m_settings.bounds.legSpeed;
    m_limits.legAcceleration = m_settings.bounds.legAcceleration;
}

MotionLimits MotionPlanner::limitsAt(const Pose& pose) const {
    return limitsFrom(m_limits, m_model->actuators(pose), m_settings.strokeSlack);
}

MotionCheck MotionPlanner::check(const Pose& pose) const {
    return checkPose(*m_model, m_limits, pose);
}

PlannedMotion MotionPlanner::plan(const PlanStart& start, const MotionRequest& request,
                                  const PlanBudget& budget) const {
    return planMotion(*m_model, m_settings.bounds, m_limits, m_settings.strokeSlack, start, request, budget);
}

MotionCheck MotionPlanner::check(const Pose& from, const Pose& to, MotionMode mode) const {
    return plan({m_model->actuators(from), from}, StraightMove{to, mode}).check;
}

} // namespace hexapose
