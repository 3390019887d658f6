// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/control/trajectory.h"
#include "core/device/platform_device.h"
#include "core/geometry/pose.h"
#include "core/record/event.h"

#include <chrono>
#include <optional>

namespace hexapose {

/// One Run in joint mode, from the press to the settled platform: reference and enable when that is still
/// due, the leg path, settling. Pure: time and feedback come in, requests and set-points go out.
class JointMove {
public:
    using Clock = std::chrono::steady_clock;
    enum class Phase { Referencing, Enabling, Ready, Moving, Settling, Settled, Failed };

    struct Timing {
        std::chrono::nanoseconds settleTime;
        std::chrono::nanoseconds settleTimeout;
        std::chrono::nanoseconds enableTimeout;
        std::chrono::nanoseconds referenceTimeout;
    };

    /// begun: when Run was pressed; controller: the state it was pressed in (U, D or E).
    JointMove(const Pose& target, const LegLengths& targetLengths, ControllerState controller,
              const Timing& timing, Clock::time_point begun);

    /// The request that is due now (once each), None otherwise.
    DeviceRequest takeRequest();
    /// In phase Ready the caller checks the path once more and starts from `from`, or drops the move.
    void start(const LegLengths& from, double legSpeed, Clock::time_point now);
    /// Goes on along the path: by the time since the last step, but never by more than longestStep, so that a
    /// late cycle slows the path and never makes a leap.
    void step(Clock::time_point now, std::chrono::nanoseconds longestStep);
    /// Where the legs should be after the last step; nothing before the start.
    std::optional<LegLengths> setPoint() const;
    /// After each exchange. measured is set for a fresh measurement only. Events: Referenced, Enabled,
    /// Settled, NotSettled, PreparationFailed.
    std::optional<Event> update(ControllerState controller, const std::optional<LegLengths>& measured,
                                double settleWindow, Clock::time_point now);

    Phase phase() const { return m_phase; }
    const Pose& target() const { return m_target; }
    std::chrono::nanoseconds duration() const;

private:
    std::optional<Event> prepare(ControllerState controller, Clock::time_point now);
    std::optional<Event> settle(const std::optional<LegLengths>& measured, double window,
                                Clock::time_point now);
    void enter(Phase phase, Clock::time_point now);

    Pose m_target;
    LegLengths m_targetLengths;
    Timing m_timing;
    Phase m_phase = Phase::Ready;
    DeviceRequest m_request = DeviceRequest::None;
    Clock::time_point m_phaseBegan;
    std::optional<LegTrajectory> m_trajectory;
    Clock::time_point m_started{};
    Clock::time_point m_lastStep{};
    std::chrono::nanoseconds m_pathTime{0};
    std::optional<Clock::time_point> m_insideSince;
    bool m_toldNotSettled = false;
};

} // namespace hexapose
