// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/move.h"

namespace hexapose {

namespace {

double seconds(std::chrono::nanoseconds duration) {
    return std::chrono::duration<double>(duration).count();
}

} // namespace

Move::Move(ControllerState controller, const Timing& timing, Clock::time_point begun)
    : m_timing(timing), m_phaseBegan(begun) {
    if (controller == ControllerState::Unreferenced)
        enter(Phase::Referencing, begun);
    else if (controller == ControllerState::Disabled)
        enter(Phase::Enabling, begun);
}

void Move::enter(Phase phase, Clock::time_point now) {
    m_phase = phase;
    m_phaseBegan = now;
    if (phase == Phase::Referencing)
        m_request = DeviceRequest::Reference;
    if (phase == Phase::Enabling)
        m_request = DeviceRequest::Enable;
}

DeviceRequest Move::nextRequest() {
    const DeviceRequest request = m_request;
    m_request = DeviceRequest::None;
    return request;
}

void Move::begin(Clock::time_point now) {
    m_started = now;
    enter(Phase::Moving, now);
}

std::optional<Event> Move::update(ControllerState controller, bool finished, std::optional<bool> inside,
                                  Clock::time_point now) {
    switch (m_phase) {
    case Phase::Referencing:
    case Phase::Enabling:
        return prepare(controller, now);
    case Phase::Moving:
        if (finished)
            enter(Phase::Settling, now);
        return std::nullopt;
    case Phase::Settling:
        return settle(inside, now);
    case Phase::Ready:
    case Phase::Settled:
    case Phase::Failed:
        return std::nullopt;
    }
    return std::nullopt;
}

std::optional<Event> Move::prepare(ControllerState controller, Clock::time_point now) {
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
        return Event{
            EventCode::PreparationFailed,
            PreparationFailure{referencing ? DeviceRequest::Reference : DeviceRequest::Enable, true, {}}};
    }
    return std::nullopt;
}

std::optional<Event> Move::settle(std::optional<bool> inside, Clock::time_point now) {
    if (inside && !*inside)
        m_insideSince.reset();
    if (inside && *inside) {
        if (!m_insideSince)
            m_insideSince = now;
        if (now - *m_insideSince >= m_timing.settleTime) {
            m_phase = Phase::Settled;
            return Event{EventCode::Settled, seconds(now - m_started)};
        }
    }
    if (!m_notSettledReported && now - m_phaseBegan > m_timing.settleTimeout) {
        m_notSettledReported =
            true; // it goes on waiting: the platform may still arrive, and the screen says so
        return Event{EventCode::NotSettled, seconds(now - m_phaseBegan)};
    }
    return std::nullopt;
}

} // namespace hexapose
