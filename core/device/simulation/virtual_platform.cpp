// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/simulation/virtual_platform.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kReferenced = 1e-5; ///< m from home: referencing ends
constexpr double kRoundOff = 1e-9;   ///< m; a stroke's end written in mm may read back a hair beyond

/// First-order lag with a speed limit, solved exactly: a ramp while the limit holds, then the exponential.
double servo(double length, double target, double timeConstant, double speedLimit, double seconds) {
    const double error = target - length;
    const double knee = timeConstant * speedLimit;
    const double ramp = std::max(std::abs(error) - knee, 0.0) / speedLimit;
    if (seconds <= ramp)
        return length + std::copysign(speedLimit * seconds, error);
    const double left = std::copysign(std::min(std::abs(error), knee), error);
    return target - left * std::exp((ramp - seconds) / timeConstant);
}

} // namespace

VirtualPlatform::VirtualPlatform(const PlatformGeometry& geometry, const VirtualPlatformOptions& options)
    : m_options(options), m_home(geometry.homeLengths()), m_lengths(m_home), m_targets(m_home),
      m_random(options.seed) {
    for (int leg = 0; leg < kLegCount; ++leg) {
        const Leg& source = geometry.legs[static_cast<std::size_t>(leg)];
        m_min[leg] = source.minLength;
        m_max[leg] = source.maxLength;
    }
}

void VirtualPlatform::step(std::chrono::nanoseconds duration) {
    std::chrono::nanoseconds moving = duration;
    if (m_state == ControllerState::Enabled) {
        m_unheard += duration;
        if (m_unheard >= m_options.watchdog) {
            moving -= m_unheard - m_options.watchdog;
            move(std::chrono::duration<double>(moving).count());
            return stop();
        }
    }
    if (m_state == ControllerState::Enabled || m_referencing)
        move(std::chrono::duration<double>(moving).count());
    if (m_referencing && (m_lengths - m_home).cwiseAbs().maxCoeff() < kReferenced) {
        m_referencing = false;
        m_referenced = true;
        m_state = ControllerState::Disabled;
        hold();
    }
}

void VirtualPlatform::move(double seconds) {
    for (int leg = 0; leg < kLegCount; ++leg)
        m_lengths[leg] =
            servo(m_lengths[leg], m_targets[leg] + m_loads[leg],
                  m_options.timeConstants[static_cast<std::size_t>(leg)], m_options.speedLimit, seconds);
}

VirtualPlatform::Refusal VirtualPlatform::reference() {
    if (m_state != ControllerState::Unreferenced && m_state != ControllerState::Disabled)
        return Refusal::State;
    m_state = ControllerState::Unreferenced;
    m_referenced = false;
    m_referencing = true;
    m_targets = m_home;
    return Refusal::None;
}

VirtualPlatform::Refusal VirtualPlatform::enable() {
    if (m_state == ControllerState::Enabled)
        return Refusal::None;
    if (m_state != ControllerState::Disabled)
        return Refusal::State;
    m_state = ControllerState::Enabled;
    feedWatchdog();
    hold();
    return Refusal::None;
}

/// Allowed always; a stop or a fault stays until it is cleared.
VirtualPlatform::Refusal VirtualPlatform::disable() {
    m_referencing = false;
    hold();
    if (m_state == ControllerState::Enabled)
        m_state = ControllerState::Disabled;
    return Refusal::None;
}

VirtualPlatform::Refusal VirtualPlatform::set(const LegLengths& lengths) {
    if (m_state != ControllerState::Enabled)
        return Refusal::State;
    const auto low = lengths.array() >= m_min.array() - kRoundOff;
    const auto high = lengths.array() <= m_max.array() + kRoundOff;
    if (!lengths.allFinite() || !(low && high).all())
        return Refusal::Range;
    m_targets = lengths;
    return Refusal::None;
}

void VirtualPlatform::stop() {
    m_referencing = false;
    hold();
    if (m_state != ControllerState::Fault)
        m_state = ControllerState::Stopped;
}

void VirtualPlatform::clear() {
    if (m_state != ControllerState::Stopped && m_state != ControllerState::Fault)
        return;
    hold();
    m_state = m_referenced ? ControllerState::Disabled : ControllerState::Unreferenced;
}

void VirtualPlatform::fail() {
    m_referencing = false;
    hold();
    m_state = ControllerState::Fault;
}

LegLengths VirtualPlatform::measure() {
    LegLengths measured = m_lengths;
    for (double& length : measured) {
        if (m_options.noise > 0.0)
            length += m_options.noise * m_gauss(m_random);
        if (m_options.resolution > 0.0)
            length = std::round(length / m_options.resolution) * m_options.resolution;
    }
    return measured;
}

double VirtualPlatform::shortestStroke() const {
    return m_min.minCoeff();
}

double VirtualPlatform::longestStroke() const {
    return m_max.maxCoeff();
}

} // namespace hexapose
