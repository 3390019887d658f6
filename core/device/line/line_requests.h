// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/line/line_message.h"
#include "core/device/platform_device.h"

#include <chrono>
#include <optional>
#include <vector>

namespace hexapose::line {

/// The message of a request; nothing for None.
std::optional<LineMessage> messageOf(DeviceRequest request);

/// Requests that wait for their answer.
class PendingRequests {
public:
    using Time = std::chrono::steady_clock::time_point;

    void sent(DeviceRequest request, Time time);
    /// True when the request was waited for.
    bool answered(DeviceRequest request);
    bool waitsFor(DeviceRequest request) const;
    /// Those that have waited longer; they are waited for no more.
    std::vector<DeviceRequest> takeOverdue(Time time, std::chrono::milliseconds answerWithin);
    void clear() { m_pending.clear(); }

private:
    struct Pending {
        DeviceRequest request;
        Time sentAt;
    };
    std::vector<Pending> m_pending;
};

/// A pending request that must arrive: repeated until the controller confirms it.
class Repeater {
public:
    using Time = std::chrono::steady_clock::time_point;

    void begin(Time time);
    void confirm() { m_begun.reset(); }
    bool active() const { return m_begun.has_value(); }
    /// Whether to send it now, which counts as sent; ends by itself after giveUpAfter.
    bool sendsNow(Time time, std::chrono::milliseconds every, std::chrono::milliseconds giveUpAfter);

private:
    std::optional<Time> m_begun;
    Time m_nextDue{};
};

} // namespace hexapose::line
