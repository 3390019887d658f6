// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/motion_runner.h"

#include "core/tracking/joint_motion.h"
#include "core/tracking/workspace_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexapose {

namespace {

constexpr double kGapOfFollowing = 0.5; ///< a set-point goes so far ahead of its leg, of what would stop
constexpr double kRestOfWindow = 0.5;   ///< an error so small is not corrected any more, of the settle window
constexpr double kStartOfWindow = 5.0;  ///< so far from its start a plan still holds, of the settle window
constexpr int kReplans = 3;

WorkspaceOptions workspaceOptions(const ControlOptions& options) {
    WorkspaceOptions workspace;
    workspace.gain = options.gain;
    workspace.legSpeed = options.bounds.legSpeed;
    workspace.gapLimit = kGapOfFollowing * options.followingLimit;
    workspace.restDistance = kRestOfWindow * options.settleWindow.distance;
    workspace.restAngle = kRestOfWindow * options.settleWindow.angle;
    return workspace;
}

} // namespace

MotionRunner::MotionRunner(SharedModel model, const ControlOptions& options, Planner& planner)
    : m_model(std::move(model)), m_options(options), m_planner(planner),
      m_workspace(m_model, workspaceOptions(options)) {}

/// Where the legs are. A measurement a hair beyond the end of a stroke, by no more than the settle window, is
/// that end: its noise must not stop a machine that stands there.
LegLengths MotionRunner::holdPoint(const Cycle& cycle) const {
    LegLengths hold = *cycle.measured;
    for (int i = 0; i < kLegCount; ++i) {
        const double within =
            std::min(std::max(hold[i], cycle.limits.minLength[i]), cycle.limits.maxLength[i]);
        if (std::abs(within - hold[i]) <= m_options.settleWindow.distance)
            hold[i] = within;
    }
    return hold;
}

PlanStart MotionRunner::startOf(const Cycle& cycle) const {
    return {m_setPoint ? *m_setPoint : holdPoint(cycle), *cycle.pose};
}

void MotionRunner::submit(const Cycle& cycle) {
    m_planner.submit(
        {m_order->request, startOf(cycle), cycle.limits, m_options.bounds, m_options.settleWindow.distance});
}

void MotionRunner::order(Order order, const Cycle& cycle) {
    m_order = std::move(order);
    m_replansLeft = kReplans;
    const auto& given = m_order->plan;
    const auto* move = std::get_if<StraightMove>(&m_order->request);
    // Made as this loop would make it, and still of now; a refusal of somebody else's is not taken over.
    const bool usable =
        given && move && given->isFor(*move) && given->bounds == m_options.bounds &&
        given->strokeSlack == m_options.settleWindow.distance &&
        checkStart(*given, startOf(cycle), cycle.limits, kStartOfWindow * m_options.settleWindow.distance,
                   kStartOfWindow * m_options.settleWindow.angle)
            .ok();
    if (usable)
        return;
    m_order->plan.reset();
    submit(cycle);
}

std::optional<MotionCheck> MotionRunner::plannedCheck() {
    if (!m_order)
        return std::nullopt;
    if (!m_order->plan)
        m_order->plan = m_planner.take();
    return m_order->plan ? std::optional(m_order->plan->check) : std::nullopt;
}

void MotionRunner::prepare(const Cycle& cycle) {
    m_move.emplace(cycle.controller,
                   Move::Timing{m_options.settleTime, m_options.settleTimeout, m_options.enableTimeout,
                                m_options.referenceTimeout},
                   cycle.time);
    m_goal = m_order->plan->endPose();
    m_id = m_order->id;
}

std::optional<MotionCheck> MotionRunner::startCheck(const Cycle& cycle) {
    const std::optional<MotionCheck> planned = plannedCheck();
    if (!planned || !planned->ok())
        return planned;
    const MotionCheck start = checkStart(*m_order->plan, startOf(cycle), cycle.limits,
                                         kStartOfWindow * m_options.settleWindow.distance,
                                         kStartOfWindow * m_options.settleWindow.angle);
    if (start.reason != MotionCheck::Reason::StartMoved || m_replansLeft == 0)
        return start;
    --m_replansLeft;
    m_order->plan.reset();
    submit(cycle);
    return startCheck(cycle);
}

void MotionRunner::begin(const Cycle& cycle) {
    const PlannedMotion& plan = *m_order->plan;
    const LegLengths from = startOf(cycle).setPoint;
    m_jog = nullptr;
    m_mode = plan.mode();
    m_goal = plan.endPose();
    if (plan.motion)
        m_generator = std::make_unique<WorkspaceMotion>(m_workspace, plan.motion,
                                                        std::holds_alternative<StraightMove>(plan.request)
                                                            ? WorkspaceController::Following::Path
                                                            : WorkspaceController::Following::Time,
                                                        from);
    else
        m_generator = std::make_unique<JointMotion>(from, plan.endLengths, m_options.bounds.legSpeed);
    m_move->begin(cycle.time);
    m_order.reset();
}

void MotionRunner::beginJog(const JogCommand& command, const Cycle& cycle) {
    auto jog = std::make_unique<JogMotion>(m_workspace, m_model, m_options.bounds, startOf(cycle).setPoint,
                                           *cycle.pose);
    m_jog = jog.get();
    m_generator = std::move(jog);
    m_mode = MotionMode::Workspace;
    m_id = m_jogId = command.id;
    m_goal.reset();
    m_move.emplace(ControllerState::Enabled,
                   Move::Timing{m_options.settleTime, m_options.settleTimeout, m_options.enableTimeout,
                                m_options.referenceTimeout},
                   cycle.time);
    m_move->begin(cycle.time);
    holdJog(command, cycle.time);
}

void MotionRunner::holdJog(const JogCommand& command, Clock::time_point time) {
    m_jogHeldAt = time;
    m_jog->hold(command.direction, command.speedOverride);
}

/// The press is over from here on: what is still to come of it must not start the platform again.
void MotionRunner::releaseJog() {
    if (m_jog)
        m_jog->release();
    noteJogEnded();
}

void MotionRunner::noteJogEnded() {
    if (m_jog && m_jogId != kNoMotion)
        m_endedJog = m_jogId;
}

std::optional<Event> MotionRunner::update(const Cycle& cycle) {
    if (!m_move)
        return std::nullopt;
    const std::optional<bool> inside =
        m_generator && cycle.fresh && cycle.pose
            ? std::optional(m_generator->inPosition(*cycle.fresh, *cycle.pose, m_options.settleWindow))
            : std::nullopt;
    return m_move->update(cycle.controller, m_generator && m_generator->finished(), inside, cycle.time);
}

void MotionRunner::settle() {
    m_move.reset();
    if (m_generator && m_generator->mode() == MotionMode::Joint)
        m_generator.reset();
}

void MotionRunner::end() {
    noteJogEnded();
    m_order.reset();
    m_move.reset();
    m_generator.reset();
    m_jog = nullptr;
    m_setPoint.reset();
    m_goal.reset(); // after a stop the target is where the platform is
}

void MotionRunner::tick(Clock::time_point time) {
    m_step = std::clamp<std::chrono::nanoseconds>(time - std::exchange(m_lastTick, time),
                                                  std::chrono::nanoseconds(0), m_options.longestPathStep);
}

std::optional<LegLengths> MotionRunner::nextSetPoint(const Cycle& cycle) {
    if (m_generator) {
        if (m_jog && cycle.time - m_jogHeldAt > m_options.jogHold)
            releaseJog();
        MotionGenerator::Cycle step{
            std::chrono::duration<double>(m_step).count(), cycle.held ? 0.0 : m_speed, {}, {}, cycle.limits};
        if (cycle.fresh && cycle.pose) {
            step.lengths = cycle.fresh;
            step.pose = cycle.pose;
        }
        m_setPoint = m_generator->step(step);
    } else if (!m_setPoint && !cycle.stale && cycle.measured) {
        m_setPoint = holdPoint(cycle); // for the controller's watchdog
    }
    return m_setPoint;
}

} // namespace hexapose
