// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "tests/support/scripted_device.h"

#include <utility>

namespace hexapose::testing {

namespace {
constexpr std::chrono::milliseconds kPeriod{10};
} // namespace

ScriptedDevice::ScriptedDevice(const PlatformGeometry& geometry)
    : lengths(geometry.homeLengths()), m_home(lengths), m_now(std::chrono::hours(1)) {}

void ScriptedDevice::obey(DeviceRequest request) {
    const bool down = state == ControllerState::Stopped || state == ControllerState::Fault;
    switch (request) {
    case DeviceRequest::Reference:
        if (ignoresReference)
            break;
        lengths = m_home;
        state = ControllerState::Disabled;
        break;
    case DeviceRequest::Enable:
        if (state == ControllerState::Disabled && !ignoresEnable)
            state = ControllerState::Enabled;
        break;
    case DeviceRequest::Disable:
        if (!ignoresDisable && state != ControllerState::Fault)
            state = ControllerState::Disabled;
        break;
    case DeviceRequest::Stop:
        if (ignoresStop || state == ControllerState::Fault) // a fault is not left by a stop
            break;
        if (!stopsOnlyWhenEnabled || state == ControllerState::Enabled)
            state = ControllerState::Stopped;
        break;
    case DeviceRequest::Clear:
        if (ignoresClear)
            break;
        notices.push_back(notice::Acknowledged{DeviceRequest::Clear});
        if (down)
            state = ControllerState::Disabled;
        break;
    default:
        break;
    }
}

void ScriptedDevice::write(const SetPoints& setPoints) {
    if (link == LinkState::Lost)
        return; // it reaches nobody
    received.push_back(setPoints);
    obey(setPoints.request);
    if (setPoints.lengths)
        ++m_setNumber;
    const bool taken = setPoints.lengths && state == ControllerState::Enabled && !deaf;
    if (taken)
        m_accepted = m_setNumber;
    if (taken && !stuck) {
        const LegLengths before = lengths;
        lengths = *setPoints.lengths + leftToSettle * (lengths - *setPoints.lengths);
        if (stuckLeg)
            lengths[*stuckLeg] = before[*stuckLeg];
    }
}

const DeviceFeedback& ScriptedDevice::read() {
    if (during)
        during();
    m_now += kPeriod + std::exchange(late, std::chrono::milliseconds(0));
    DeviceFeedback& feedback = m_feedback;
    feedback.lengths.reset();
    feedback.link = link;
    feedback.protectedLink = link == LinkState::Connected;
    feedback.state = link == LinkState::Connected ? state : ControllerState::Unknown;
    feedback.echoesSetPoints = echoes;
    feedback.acceptedSetPoint = echoes ? m_accepted : std::nullopt;
    feedback.period = kPeriod;
    feedback.controllerName = name;
    feedback.minLength = minLength;
    feedback.maxLength = maxLength;
    feedback.notices = std::exchange(notices, {});
    if (!silent && link != LinkState::Lost) {
        m_measuredAt = m_now;
        feedback.lengths = reportInstead.value_or(lengths);
    }
    feedback.receivedAt = m_measuredAt;
    return feedback;
}

} // namespace hexapose::testing
