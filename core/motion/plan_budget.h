// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>

namespace hexapose {

/// Processor time that the calling thread has used so far.
std::chrono::nanoseconds threadProcessorTime();

/// How much processor time a plan may take: a plan is refused after the same work on a busy machine as on an
/// idle one.
struct PlanBudget {
    std::chrono::nanoseconds time = std::chrono::milliseconds(50);
    std::function<std::chrono::nanoseconds()> now = &threadProcessorTime;
    std::function<bool()> isCancelled = {}; ///< ends it as if the time were up, for a plan nobody waits for
};

/// Runs from its construction, in one thread.
class PlanTimer {
public:
    explicit PlanTimer(const PlanBudget& budget);
    /// Asked in every loop of a plan; cheap, as the clock is read every 16th time only. Once true it stays
    /// so.
    bool expired();

private:
    PlanBudget m_budget;
    std::chrono::nanoseconds m_end;
    int m_asked = 0;
    bool m_expired = false;
};

} // namespace hexapose
