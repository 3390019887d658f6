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

void PendingRequests::sent(DeviceRequest request, Time time) {
    answered(request);
    m_pending.push_back({request, time});
}

bool PendingRequests::answered(DeviceRequest request) {
    return std::erase_if(m_pending, [request](const Pending& p) { return p.request == request; }) > 0;
}

bool PendingRequests::waitsFor(DeviceRequest request) const {
    return std::any_of(m_pending.begin(), m_pending.end(),
                       [request](const Pending& p) { return p.request == request; });
}

std::vector<DeviceRequest> PendingRequests::takeOverdue(Time time, std::chrono::milliseconds answerWithin) {
    std::vector<DeviceRequest> overdue;
    for (const Pending& pending : m_pending)
        if (time - pending.sentAt > answerWithin)
            overdue.push_back(pending.request);
    for (const DeviceRequest request : overdue)
        answered(request);
    return overdue;
}

void Repeater::begin(Time time) {
    m_begun = time;
    m_nextDue = time;
}

bool Repeater::sendsNow(Time time, std::chrono::milliseconds every, std::chrono::milliseconds giveUpAfter) {
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
