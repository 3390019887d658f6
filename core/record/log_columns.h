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

/// In the log's order; resources/manual/files.md says what each holds. Measured columns are empty in a row
/// without a fresh measurement.
const std::vector<LogColumn>& logColumns();

std::string logHeader();                                          ///< one line with '\n'
void appendLogRow(const Snapshot& snapshot, std::string& buffer); ///< one line with '\n'

} // namespace hexapose
