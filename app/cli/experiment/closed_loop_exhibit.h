// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/experiment/closed_loop_trial.h"
#include "app/cli/reproduce/exhibit.h"

namespace hexapose::experiment {

/// Both modes over the same moves.
struct BothModes {
    std::vector<MoveOutcome> joint, workspace;
};

/// Joint mode beside workspace mode: tables, CSV, pictures and what was expected. calm: without the push.
reproduce::Exhibit closedLoopExhibit(const TrialSettings& settings, const BothModes& pushed,
                                     const BothModes& calm);

} // namespace hexapose::experiment
