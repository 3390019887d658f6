// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"
#include "core/machine/feedback_monitor.h"
#include "core/record/event.h"

#include <functional>
#include <optional>

namespace hexapose {

/// The loop's side of a device: what was read last, how old it is, who the controller is and what it says of
/// its state.
class ControllerLink {
public:
    using Clock = std::chrono::steady_clock;

    ControllerLink(PlatformDevice& device, std::chrono::milliseconds staleAfter)
        : m_device(device), m_monitor(staleAfter) {}

    void read(const std::function<Clock::time_point()>& now);
    void write(const SetPoints& setPoints) { m_device.write(setPoints); }
    void interrupt() { m_device.interrupt(); }

    const DeviceFeedback& feedback() const { return *m_feedback; }
    const FeedbackMonitor& monitor() const { return m_monitor; }
    bool acceptsCommands() const { return m_feedback->link == LinkState::Connected; }

    struct StateReport {
        ControllerState before, after; ///< Unknown while there is no controller that accepts commands
        bool isNews;                   ///< false: an old report, which does not reflect the requests since
    };
    /// The state that the controller reports now, compared with the last call.
    StateReport takeStateReport();
    ControllerState state() const { return m_state; } ///< as of the last report

    /// The controller's name and limits, when they are not those of the last call: what was checked and sent
    /// so far was meant for another machine.
    std::optional<ControllerIdentity> takeNewIdentity();

private:
    PlatformDevice& m_device;
    const DeviceFeedback m_nothing;
    const DeviceFeedback* m_feedback = &m_nothing; ///< the device's own
    FeedbackMonitor m_monitor;
    ControllerState m_state = ControllerState::Unknown;
    std::optional<ControllerIdentity> m_identity;
};

} // namespace hexapose
