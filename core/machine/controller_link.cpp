// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/controller_link.h"

#include <utility>

namespace hexapose {

void ControllerLink::read(const std::function<Clock::time_point()>& now) {
    m_feedback = &m_device.read();
    m_monitor.update(*m_feedback, now());
    if (m_feedback->link == LinkState::Lost)
        m_monitor.forget();
}

ControllerLink::StateReport ControllerLink::takeStateReport() {
    const ControllerState after = acceptsCommands() ? m_feedback->state : ControllerState::Unknown;
    const ControllerState before = std::exchange(m_state, after);
    return {before, after, m_feedback->lengths.has_value() || before != after};
}

std::optional<ControllerIdentity> ControllerLink::takeNewIdentity() {
    if (!acceptsCommands())
        return std::nullopt;
    ControllerIdentity present{m_feedback->controllerName, m_feedback->minLength, m_feedback->maxLength};
    if (m_identity == present)
        return std::nullopt;
    const bool first = !m_identity;
    m_identity = std::move(present);
    return first ? std::nullopt : m_identity;
}

} // namespace hexapose
