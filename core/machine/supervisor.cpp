// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/supervisor.h"

#include <utility>

namespace hexapose {

namespace {

/// What is measured may come so much nearer to a singular pose than a move may be planned.
constexpr double kMeasuredMargin = 0.5;

} // namespace

Supervisor::Supervisor(SharedModel model, const ControlOptions& options, ControllerLink& link,
                       PoseEstimate& estimate, MotionRunner& motion)
    : m_model(std::move(model)), m_options(options),
      m_planner(m_model, plannerSettings(options, m_model->geometry())), m_link(link), m_estimate(estimate),
      m_motion(motion), m_following(options.followingLimit, options.echoWithin) {}

MotionRunner::Cycle Supervisor::cycle() const {
    return {m_time,
            m_link.state(),
            m_link.monitor().stale(),
            m_link.feedback().lengths,
            m_estimate.lengths(),
            m_estimate.pose(),
            limits(),
            m_machine.held};
}

RunState Supervisor::state() const {
    return m_link.feedback().link == LinkState::ListenOnly ? RunState::Disabled : m_machine.run;
}

CommandSet Supervisor::allowed() const {
    return allowedCommands(m_machine, m_link.feedback().link);
}

bool Supervisor::mayCommand(Command command) const {
    return allowed().contains(command);
}

bool Supervisor::apply(MachineEvent event) {
    const Transition made = transition(m_machine, event);
    if (!made.defined)
        return false;
    m_machine = made.next;
    execute(made.action);
    return true;
}

void Supervisor::execute(MachineAction action) {
    switch (action) {
    case MachineAction::None:
        return;
    case MachineAction::Plan:
        return m_motion.order(*std::exchange(m_order, std::nullopt), cycle());
    case MachineAction::Prepare:
        m_enabledByUs = true;
        m_requests.askToReference();
        m_requests.askToEnable();
        return m_motion.prepare(cycle());
    case MachineAction::BeginPath:
        return m_motion.begin(cycle());
    case MachineAction::BeginJog:
        return m_motion.beginJog(*std::exchange(m_jogCommand, std::nullopt), cycle());
    case MachineAction::SendReference:
        m_enabledByUs = true;
        m_requests.askToReference();
        return m_requests.ask(DeviceRequest::Reference);
    case MachineAction::SendEnable:
        m_enabledByUs = true;
        return m_requests.ask(DeviceRequest::Enable);
    case MachineAction::SendClear:
        endMotion();
        return m_requests.ask(DeviceRequest::Clear);
    case MachineAction::EndMotion:
        return endMotion();
    case MachineAction::EndMotionAndDisable:
        endMotion();
        m_disableAsked = true;
        return m_requests.ask(DeviceRequest::Disable);
    case MachineAction::EndMotionAndStop:
        endMotion();
        return m_requests.stop();
    case MachineAction::EndMotionAndStopAndDisable:
        endMotion();
        return m_requests.stopAndDisable();
    }
}

void Supervisor::endMotion() {
    m_motion.end();
    m_following.reset();
    m_requests.forgetReference();
}

void Supervisor::stop(Event cause) {
    raise(std::move(cause));
    stopSilently();
}

void Supervisor::stopSilently() {
    m_unresolvedStop.reset();
    apply(MachineEvent::Trips);
}

void Supervisor::beginCycle(Clock::time_point time) {
    m_time = time;
    m_planner.setControllerLimits(m_link.feedback().minLength, m_link.feedback().maxLength);
    m_motion.tick(time);
}

/// Why nothing can move now, whatever is asked for.
std::optional<MotionInhibit> Supervisor::motionInhibit() const {
    if (m_link.monitor().stale())
        return MotionInhibit{};
    if (!m_estimate.pose())
        return MotionInhibit{m_estimate.solution().status};
    return std::nullopt;
}

/// The last gate for what is measured: singularity and side.
std::optional<Event> Supervisor::nearLimit() const {
    const double margin = kMeasuredMargin * limits().singularityMargin;
    const double smallest = m_estimate.singularity().smallestSingularValue;
    const double q = m_estimate.determinantRatio();
    MotionCheck check;
    if (!(smallest >= margin)) {
        check.reason = MotionCheck::Reason::NearSingular;
        check.value = smallest;
        check.bound = margin;
    } else if (!(q > 0.0)) {
        check.reason = MotionCheck::Reason::WrongSideOfSingularity;
        check.value = q;
    }
    return check.ok() ? std::nullopt : std::optional(Event{EventCode::StoppedOnLimits, check});
}

/// While something moves, or a pose is held by what is measured, every measurement must be good.
void Supervisor::watch() {
    const bool stale = m_link.monitor().stale();
    if (stale != std::exchange(m_wasStale, stale)) {
        if (stale)
            m_following.reset();
        using Milliseconds = std::chrono::duration<double, std::milli>;
        raise(stale ? Event{EventCode::DataStale, Milliseconds(m_link.monitor().age()).count()}
                    : Event{EventCode::DataFresh});
    }
    const std::optional<LegLengths>& fresh = m_link.feedback().lengths;
    const bool led = m_motion.active() || m_motion.generates();
    if (led && stale)
        return stop({EventCode::StoppedOnStaleData});
    if (led && fresh && !m_estimate.pose())
        return stop({EventCode::StoppedOnSolver, m_estimate.solution().status});
    if (m_motion.generates() && fresh) {
        if (std::optional<Event> cause = nearLimit())
            return stop(std::move(*cause));
        if (const std::optional<PoseReference> reference = m_motion.reference())
            if (std::optional<Event> cause =
                    m_following.checkPath(m_model->actuators(reference->pose), *fresh, m_motion.stalls()))
                return stop(std::move(*cause));
    }
    if (m_motion.setPoint() && m_estimate.pose())
        if (std::optional<Event> cause =
                m_following.checkLegs(m_link.feedback(), *m_motion.setPoint(), m_time))
            stop(std::move(*cause));
}

void Supervisor::advance() {
    if (std::optional<Event> event = m_motion.takeEvent())
        raise(std::move(*event));
    followPlan();
    const std::optional<Move::Phase> before = m_motion.phase();
    if (std::optional<Event> event = m_motion.update(cycle()))
        raise(std::move(*event));
    const std::optional<Move::Phase> after = m_motion.phase();
    if (before == Move::Phase::Moving && after == Move::Phase::Settling)
        apply(MachineEvent::PathEnds);
    if (after == Move::Phase::Failed && !apply(MachineEvent::MotionDropped))
        endMotion();
    if (after == Move::Phase::Settled) {
        apply(MachineEvent::Settles);
        m_motion.settle();
    }
    if (after == Move::Phase::Ready)
        tryToBegin();
}

/// What becomes of a motion whose plan is there.
void Supervisor::followPlan() {
    if (m_machine.pending != Pending::Plan)
        return;
    const std::optional<MotionCheck> check = m_motion.plannedCheck();
    if (!check)
        return;
    if (check->ok() && apply(MachineEvent::PlanReady)) {
        if (m_motion.phase() == Move::Phase::Referencing)
            raise({EventCode::Referencing});
        return;
    }
    const MotionId id = m_motion.orderId();
    m_motion.forgetOrder();
    apply(MachineEvent::PlanRefused);
    if (!check->ok())
        raise({EventCode::MoveRefused, *check});
    else
        refuse(Command::Run, id);
}

/// The drives are on. Referencing may have moved the legs: the plan has to fit where they are now.
void Supervisor::tryToBegin() {
    if (m_link.state() != ControllerState::Enabled || !m_estimate.pose())
        return;
    const std::optional<MotionCheck> check = m_motion.startCheck(cycle());
    if (!check)
        return;
    if (!check->ok()) {
        raise({EventCode::MoveRefused, *check});
        apply(MachineEvent::MotionDropped);
    } else if (apply(MachineEvent::PathBegins)) {
        raise({EventCode::MoveStarted, m_motion.duration()});
    }
}

SetPoints Supervisor::output() {
    SetPoints out;
    if (!m_motion.setPoint())
        m_following.reset();
    if (m_requests.empty() && m_motion.active())
        m_requests.ask(m_motion.nextRequest());
    out.request = m_requests.takeNext();
    if (out.request == DeviceRequest::Stop || !drivesAreOn(m_machine.run) || !m_machine.hasControl ||
        !m_link.acceptsCommands() || m_link.state() != ControllerState::Enabled)
        return out;
    const std::optional<LegLengths> setPoint = m_motion.nextSetPoint(cycle());
    if (!setPoint)
        return out;
    if (const MotionCheck check = checkLegs(limits(), *setPoint); !check.ok()) {
        stop({EventCode::StoppedOnLimits, check});
        return {std::nullopt, m_requests.takeNext()};
    }
    out.lengths = setPoint;
    m_following.sent(m_time);
    return out;
}

bool Supervisor::mayBeEnabled() const {
    return m_enabledByUs || m_link.state() == ControllerState::Enabled;
}

} // namespace hexapose
