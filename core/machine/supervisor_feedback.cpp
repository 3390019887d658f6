// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/supervisor.h"

#include <utility>

namespace hexapose {

namespace {

constexpr std::chrono::seconds kRepeatInterval{1};          ///< of the same refusal
constexpr std::chrono::milliseconds kStateComesWithin{300}; ///< some feedback periods

bool isDown(ControllerState state) {
    return state == ControllerState::Stopped || state == ControllerState::Fault;
}

} // namespace

void Supervisor::processFeedback() {
    for (const DeviceNotice& notice : m_link.feedback().notices)
        std::visit([this](const auto& n) { on(n); }, notice);
    followController();
    resolveStopCause();
    checkIdentity();
}

/// The machine's state follows the controller's, as far as the table has it so.
void Supervisor::followController() {
    const MachineState was = m_machine;
    const bool wasActive = m_motion.active();
    const ControllerLink::StateReport report = m_link.takeStateReport();
    if (report.after == ControllerState::Unknown) {
        apply(MachineEvent::LinkGone);
        return;
    }
    if (!report.isNews)
        return;
    if (report.before != report.after) {
        if (report.before == ControllerState::Stopped)
            apply(MachineEvent::LeftStop);
        if (report.before == ControllerState::Fault)
            apply(MachineEvent::LeftFault);
        if (report.before == ControllerState::Unreferenced)
            m_requests.noteReferenceTaken(); // whether or not its answer came through
    }
    apply(eventOf(report.after));
    reportStateChange(report, was, wasActive);
    const bool off =
        report.after == ControllerState::Disabled || report.after == ControllerState::Unreferenced;
    if (off && std::exchange(m_disableAsked, false))
        m_enabledByUs = false;
}

void Supervisor::reportStateChange(const ControllerLink::StateReport& report, const MachineState& was,
                                   bool wasActive) {
    if (was.owesStop && !m_machine.owesStop)
        return raise({EventCode::StoppedAfterLoss});
    const bool wasDown = isDown(was.run);
    // A controller may answer a stop without a state for it; Clear ends that stop too.
    if (wasDown && (m_machine.run == RunState::Disabled || m_machine.run == RunState::Unreferenced))
        return raise({EventCode::Cleared});
    if (report.before == report.after)
        return;
    const bool wentDown = isDown(report.after) || (report.before == ControllerState::Enabled &&
                                                   report.after != ControllerState::Enabled);
    const bool asked = m_disableAsked && !isDown(report.after);
    if (wentDown && !asked && was.run != RunState::Stopped &&
        (wasActive || report.before == ControllerState::Enabled))
        raise({EventCode::StoppedByController, report.after});
    // What comes back behind the operator's stop is stopped again: its own state is no news.
    if (wasActive || wasDown || isDown(m_machine.run))
        return;
    if (report.after == ControllerState::Enabled)
        raise({EventCode::Enabled});
    else if (report.after == ControllerState::Disabled)
        raise({report.before == ControllerState::Unreferenced ? EventCode::Referenced : EventCode::Disabled});
}

/// Names what stopped the motion, once the controller's state has come, or that it restarted, or nothing
/// more.
void Supervisor::resolveStopCause() {
    if (!m_unresolvedStop)
        return;
    if (!m_link.acceptsCommands()) { // the restart, or the loss, was reported
        m_unresolvedStop.reset();
    } else if (m_link.state() != ControllerState::Enabled) {
        raise({EventCode::StoppedByController, m_link.state()});
        m_unresolvedStop.reset();
    } else if (m_time - m_unresolvedSince > kStateComesWithin) {
        raise({EventCode::StoppedOnRefusal, *std::exchange(m_unresolvedStop, std::nullopt)});
    }
}

void Supervisor::checkIdentity() {
    const std::optional<ControllerIdentity> identity = m_link.takeNewIdentity();
    if (identity && (m_motion.active() || m_motion.setPoint()))
        stop({EventCode::StoppedOnNewIdentity, *identity});
}

void Supervisor::on(const notice::Identified& notice) {
    raise({EventCode::Connected, DeviceText{notice.name}});
}

void Supervisor::on(const notice::Fault& notice) {
    raise({EventCode::ControllerFault, DeviceText{notice.text}});
}

void Supervisor::on(const notice::Acknowledged& notice) {
    if (notice.request == DeviceRequest::Reference)
        m_requests.noteReferenceTaken();
    if (notice.request == DeviceRequest::Clear)
        apply(MachineEvent::ClearConfirmed);
}

void Supervisor::on(const notice::ClockWentBack&) {
    if (m_motion.active())
        stop({EventCode::ClockWentBack});
    else
        raise({EventCode::ClockWentBack});
}

void Supervisor::on(const notice::ListenOnly&) {
    raise({EventCode::ListenOnly});
}

void Supervisor::on(const notice::LinkLost& notice) {
    raise({EventCode::LinkLost, notice.failure});
}

/// A frame may be lost: what prepares a motion is asked for again, and given up soon when nothing answers.
void Supervisor::on(const notice::NoAnswer& notice) {
    raise({EventCode::NoAnswer, notice.request});
    if (notice.request == DeviceRequest::Clear)
        apply(MachineEvent::ClearRefused);
    const bool preparing = m_motion.preparing();
    const bool reference = notice.request == DeviceRequest::Reference && !m_requests.referenceTaken();
    const bool enable = notice.request == DeviceRequest::Enable && preparing;
    if (!m_link.acceptsCommands() || (!reference && !enable) || m_requests.repeat(notice.request))
        return;
    if (preparing) {
        apply(MachineEvent::MotionDropped);
        raise({EventCode::PreparationFailed, PreparationFailure{notice.request, false, {}}});
    }
}

void Supervisor::on(const notice::Refused& notice) {
    const DeviceRefusal& refusal = notice.refusal;
    const bool reference = refusal.request == DeviceRequest::Reference;
    if (refusal.request == DeviceRequest::SetPoint)
        return onSetPointRefused(refusal);
    if (refusal.request == DeviceRequest::Clear)
        apply(MachineEvent::ClearRefused);
    // A refusal of a reference that was asked for again before a late answer came refers to the repeat.
    const bool late = reference && (m_requests.referenceTaken() ||
                                    (m_motion.active() && m_motion.phase() != Move::Phase::Referencing));
    if (!late && m_motion.preparing() && (reference || refusal.request == DeviceRequest::Enable)) {
        apply(MachineEvent::MotionDropped);
        return raise({EventCode::PreparationFailed, PreparationFailure{refusal.request, true, refusal}});
    }
    raise({EventCode::ControllerRefused, refusal});
}

void Supervisor::onSetPointRefused(const DeviceRefusal& refusal) {
    if (isInMotion(m_machine.run)) {
        if (refusal.reason != RefusalReason::State)
            return stop({EventCode::StoppedOnRefusal, refusal});
        // The drives went down on their own; the measurement that says so comes a moment later.
        raise({EventCode::ControllerRefused, refusal});
        stopSilently();
        m_unresolvedStop = refusal;
        m_unresolvedSince = m_time;
        return;
    }
    // A held set-point is refused in every cycle: report it once a second.
    if (refusal == m_lastSetRefusal && m_time - m_lastSetRefusalAt < kRepeatInterval)
        return;
    m_lastSetRefusal = refusal;
    m_lastSetRefusalAt = m_time;
    raise({EventCode::ControllerRefused, refusal});
}

} // namespace hexapose
