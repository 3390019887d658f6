// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/platform_device.h"
#include "core/geometry/leg_lengths.h"
#include "core/record/event.h"

#include <chrono>
#include <optional>

namespace hexapose {

/// Whether the set-points that go out are followed: by the legs, and by the controller's echo of the last one
/// it accepted. Pure; fed once a cycle.
class FollowingErrorMonitor {
public:
    using Clock = std::chrono::steady_clock;

    /// largestGap: m, of any leg. echoWithin: at least; three feedback periods when those are longer.
    FollowingErrorMonitor(double largestGap, std::chrono::nanoseconds echoWithin)
        : m_largestGap(largestGap), m_echoWithin(echoWithin) {}

    /// Set-points no longer go out, or those before are forgotten.
    void reset() { m_unechoedSince.reset(); }
    /// A set-point goes out.
    void sent(Clock::time_point now);
    /// In a motion that is closed on the pose: against the lengths that belong to where the path has the
    /// platform, m. A blocked leg cannot be detected from its set-point there, which follows the leg.
    std::optional<Event> checkPath(const LegLengths& reference, const LegLengths& measured,
                                   bool stalls) const;
    /// After a read with a fresh measurement: StoppedOnFollowingError or StoppedOnNoEcho, or nothing.
    /// setPoint: in force, m.
    std::optional<Event> checkLegs(const DeviceFeedback& feedback, const LegLengths& setPoint,
                                   Clock::time_point now);

private:
    double m_largestGap;
    std::chrono::nanoseconds m_echoWithin;
    std::optional<std::int32_t> m_echo;
    std::optional<Clock::time_point> m_unechoedSince; ///< when the first one after the last echo was sent
    int m_unechoed = 0;
};

} // namespace hexapose
