// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/snapshot.h"

#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// One column of the session log: its name (with unit) and how a snapshot's value is written; empty when
/// unknown.
struct LogColumn {
    std::string_view name;
    void (*append)(const Snapshot& snapshot, std::string& line);
};

/// time_s, time_iso, l1_mm..l6_mm, l1_set_mm..l6_set_mm, x_target_mm, y_target_mm, z_target_mm,
/// alpha_target_deg, beta_target_deg, gamma_target_deg, x_mm, y_mm, z_mm, alpha_deg, beta_deg, gamma_deg,
/// status, iterations, residual_mm, state, age_ms, dropped, event. Target columns hold the goal of the
/// present or last Run. Measured columns are empty in a row without a fresh measurement.
const std::vector<LogColumn>& logColumns();

std::string logHeader();                                          ///< one line with '\n'
void appendLogRow(const Snapshot& snapshot, std::string& buffer); ///< one line with '\n'

} // namespace hexapose
