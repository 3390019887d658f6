// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/snapshot.h"

#include <string>

namespace hexapose {

/// The session log as text: a column for each of quantities(), in their order.
std::string logHeader();                                          ///< one line with '\n'
void appendLogRow(const Snapshot& snapshot, std::string& buffer); ///< one line with '\n'

} // namespace hexapose
