// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/line_requests.h"

#include <algorithm>

namespace hexapose::line {

std::optional<LineMessage> messageOf(DeviceRequest request) {
    switch (request) {
    case DeviceRequest::Reference:
        return Home{};
    case DeviceRequest::Enable:
        return Enable{};
    case DeviceRequest::Disable:
        return Disable{};
    case DeviceRequest::Stop:
        return Stop{};
    case DeviceRequest::Clear:
        return Clear{};
    case DeviceRequest::None:
    case DeviceRequest::SetPoint: // the rest has no request of its own, or is the device's own affair
    case DeviceRequest::Period:
    case DeviceRequest::Hello:
    case DeviceRequest::Identity:
    case DeviceRequest::Other:
        return std::nullopt;
    }
    return std::nullopt;
}

void PendingRequests::sent(std::string_view type, Time time) {
    answered(type);
    m_pending.push_back({std::string(type), time});
}

bool PendingRequests::answered(std::string_view type) {
    return std::erase_if(m_pending, [type](const Pending& p) { return p.type == type; }) > 0;
}

bool PendingRequests::waitsFor(std::string_view type) const {
    return std::any_of(m_pending.begin(), m_pending.end(),
                       [type](const Pending& p) { return p.type == type; });
}

std::vector<std::string> PendingRequests::takeOverdue(Time time, std::chrono::milliseconds answerWithin) {
    std::vector<std::string> overdue;
    for (const Pending& pending : m_pending)
        if (time - pending.sentAt > answerWithin)
            overdue.push_back(pending.type);
    for (const std::string& type : overdue)
        answered(type);
    return overdue;
}

void Repeater::begin(Time time) {
    m_begun = time;
    m_nextDue = time;
}

bool Repeater::takeDue(Time time, std::chrono::milliseconds every, std::chrono::milliseconds giveUpAfter) {
    if (!m_begun || time < m_nextDue)
        return false;
    if (time - *m_begun > giveUpAfter) {
        m_begun.reset();
        return false;
    }
    m_nextDue = time + every;
    return true;
}

} // namespace hexapose::line
