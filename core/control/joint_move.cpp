// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/control/joint_move.h"

#include <algorithm>

namespace hexapose {

namespace {

double seconds(std::chrono::nanoseconds duration) {
    return std::chrono::duration<double>(duration).count();
}

} // namespace

JointMove::JointMove(const Pose& target, const LegLengths& targetLengths, ControllerState controller,
                     const Timing& timing, Clock::time_point begun)
    : m_target(target), m_targetLengths(targetLengths), m_timing(timing), m_phaseBegan(begun) {
    if (controller == ControllerState::Unreferenced)
        enter(Phase::Referencing, begun);
    else if (controller == ControllerState::Disabled)
        enter(Phase::Enabling, begun);
}

void JointMove::enter(Phase phase, Clock::time_point now) {
    m_phase = phase;
    m_phaseBegan = now;
    if (phase == Phase::Referencing)
        m_request = DeviceRequest::Reference;
    if (phase == Phase::Enabling)
        m_request = DeviceRequest::Enable;
}

DeviceRequest JointMove::takeRequest() {
    const DeviceRequest request = m_request;
    m_request = DeviceRequest::None;
    return request;
}

void JointMove::start(const LegLengths& from, double legSpeed, Clock::time_point now) {
    m_trajectory.emplace(from, m_targetLengths, legSpeed);
    m_started = m_lastStep = now;
    m_pathTime = std::chrono::nanoseconds(0);
    enter(Phase::Moving, now);
}

void JointMove::step(Clock::time_point now, std::chrono::nanoseconds longestStep) {
    m_pathTime +=
        std::clamp<std::chrono::nanoseconds>(now - m_lastStep, std::chrono::nanoseconds(0), longestStep);
    m_lastStep = now;
}

std::optional<LegLengths> JointMove::setPoint() const {
    if (!m_trajectory)
        return std::nullopt;
    return m_trajectory->at(m_pathTime);
}

std::chrono::nanoseconds JointMove::duration() const {
    return m_trajectory ? m_trajectory->duration() : std::chrono::nanoseconds(0);
}

std::optional<Event> JointMove::update(ControllerState controller, const std::optional<LegLengths>& measured,
                                       double settleWindow, Clock::time_point now) {
    switch (m_phase) {
    case Phase::Referencing:
    case Phase::Enabling:
        return prepare(controller, now);
    case Phase::Moving:
        if (m_pathTime >= m_trajectory->duration())
            enter(Phase::Settling, now);
        return std::nullopt;
    case Phase::Settling:
        return settle(measured, settleWindow, now);
    case Phase::Ready:
    case Phase::Settled:
    case Phase::Failed:
        return std::nullopt;
    }
    return std::nullopt;
}

std::optional<Event> JointMove::prepare(ControllerState controller, Clock::time_point now) {
    const bool referencing = m_phase == Phase::Referencing;
    if (controller == ControllerState::Enabled) {
        enter(Phase::Ready, now);
        return Event{EventCode::Enabled};
    }
    if (referencing && controller == ControllerState::Disabled) {
        enter(Phase::Enabling, now);
        return Event{EventCode::Referenced};
    }
    if (now - m_phaseBegan > (referencing ? m_timing.referenceTimeout : m_timing.enableTimeout)) {
        m_phase = Phase::Failed;
        return Event{EventCode::PreparationFailed, 0.0, referencing ? "reference" : "enable"};
    }
    return std::nullopt;
}

std::optional<Event> JointMove::settle(const std::optional<LegLengths>& measured, double window,
                                       Clock::time_point now) {
    if (measured) {
        const bool inside = (*measured - m_targetLengths).cwiseAbs().maxCoeff() <= window;
        if (!inside)
            m_insideSince.reset();
        else if (!m_insideSince)
            m_insideSince = now;
        if (m_insideSince && now - *m_insideSince >= m_timing.settleTime) {
            m_phase = Phase::Settled;
            return Event{EventCode::Settled, seconds(now - m_started)};
        }
    }
    if (!m_toldNotSettled && now - m_phaseBegan > m_timing.settleTimeout) {
        m_toldNotSettled = true; // it goes on waiting: the platform may still arrive, and the screen says so
        return Event{EventCode::NotSettled, seconds(now - m_phaseBegan)};
    }
    return std::nullopt;
}

} // namespace hexapose
