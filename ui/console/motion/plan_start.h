// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/motion/motion_planner.h"
#include "core/record/snapshot.h"
#include "ui/common/job.h"

#include <optional>

namespace hexapose {

/// Where a motion would start, as the loop sees it: from the set-point in force, or where the legs are.
/// Nothing while that is not known.
inline std::optional<PlanStart> planStart(const Snapshot& snapshot) {
    const auto& lengths = snapshot.commandedLengths ? snapshot.commandedLengths : snapshot.measuredLengths;
    if (snapshot.stale || !snapshot.measuredPose || !lengths) {
        return std::nullopt;
    }
    return PlanStart{*lengths, *snapshot.measuredPose};
}

/// Of a plan that is made in a job, and ends when that is cancelled.
inline PlanBudget planBudget(const Job& job) {
    PlanBudget budget;
    budget.isCancelled = [&job] { return job.isCancelled(); };
    return budget;
}

} // namespace hexapose
