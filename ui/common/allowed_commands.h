// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/record/command_set.h"
#include "core/record/snapshot.h"

namespace hexapose {

/// What the loop would accept now: the one place that every button asks.
CommandSet allowedCommands(const Snapshot& snapshot);

} // namespace hexapose
