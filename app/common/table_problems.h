// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table.h"

namespace hexapose {

/// On standard error the first hundred problems of a table's file, "run.csv:812: l3_mm: ...", and how many
/// more there are. Returns whether rows were left out or cells are missing for a cause.
bool printProblems(const Table& table);

} // namespace hexapose
