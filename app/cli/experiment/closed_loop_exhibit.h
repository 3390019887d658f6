// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/experiment/closed_loop_trial.h"
#include "app/cli/reproduce/exhibit.h"

namespace hexapose::experiment {

/// Joint mode beside workspace mode over the same moves: tables, CSV, pictures and what was expected.
reproduce::Exhibit closedLoopExhibit(const TrialSettings& settings, const std::vector<MoveOutcome>& joint,
                                     const std::vector<MoveOutcome>& workspace);

} // namespace hexapose::experiment
