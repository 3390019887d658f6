// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/controller_state.h"
#include "core/record/device_refusal.h"
#include "core/record/event.h"

#include <chrono>
#include <optional>

namespace hexapose {

/// One motion that was asked for, from the press to the settled platform: reference and enable when that is
/// still due, the path, settling. The path itself is the generator's. Pure: time and feedback
/// come in, requests and events go out.
class Move {
public:
    using Clock = std::chrono::steady_clock;
    enum class Phase { Referencing, Enabling, Ready, Moving, Settling, Settled, Failed };

    struct Timing {
        std::chrono::nanoseconds settleTime;
        std::chrono::nanoseconds settleTimeout;
        std::chrono::nanoseconds enableTimeout;
        std::chrono::nanoseconds referenceTimeout;
    };

    /// begun: when it was asked for; controller: the state then (U, D or E).
    Move(ControllerState controller, const Timing& timing, Clock::time_point begun);

    /// The request that is due now (once each), None otherwise.
    DeviceRequest nextRequest();
    /// In phase Ready the caller checks the path once more and begins it, or drops the move.
    void begin(Clock::time_point now);
    /// After each exchange. finished: the set-points are at the end. inside: the platform is inside the
    /// window about the end; nothing without a fresh measurement. Events: Referenced, Enabled, Settled,
    /// NotSettled, PreparationFailed.
    std::optional<Event> update(ControllerState controller, bool finished, std::optional<bool> inside,
                                Clock::time_point now);

    Phase phase() const { return m_phase; }
    bool preparing() const { return m_phase == Phase::Referencing || m_phase == Phase::Enabling; }
    bool moving() const { return m_phase == Phase::Moving || m_phase == Phase::Settling; }

private:
    std::optional<Event> prepare(ControllerState controller, Clock::time_point now);
    std::optional<Event> settle(std::optional<bool> inside, Clock::time_point now);
    void enter(Phase phase, Clock::time_point now);

    Timing m_timing;
    Phase m_phase = Phase::Ready;
    DeviceRequest m_request = DeviceRequest::None;
    Clock::time_point m_phaseBegan;
    Clock::time_point m_started{};
    std::optional<Clock::time_point> m_insideSince;
    bool m_notSettledReported = false;
};

} // namespace hexapose
