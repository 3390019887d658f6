// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/arguments.h"

namespace hexapose {

/// Exit statuses of the command line's contract.
inline constexpr int kExitDone = 0;
inline constexpr int kExitSomeFailed = 1;
inline constexpr int kExitBadInput = 2;

// What each command takes, and its work: it returns the exit status; bad usage or input is an InputError.
Usage inverseUsage();
int inverseCommand(const Arguments& arguments);
Usage forwardUsage();
int forwardCommand(const Arguments& arguments);
Usage trainUsage();
int trainCommand(const Arguments& arguments);
Usage simulateUsage();
int simulateCommand(const Arguments& arguments);
Usage runUsage();
int runCommand(const Arguments& arguments);
Usage reportUsage();
int reportCommand(const Arguments& arguments);
Usage summaryUsage();
int summaryCommand(const Arguments& arguments);
Usage verifyUsage();
int verifyCommand(const Arguments& arguments);
Usage compareUsage();
int compareCommand(const Arguments& arguments);
Usage trackUsage();
int trackCommand(const Arguments& arguments);
Usage reproduceUsage();
int reproduceCommand(const Arguments& arguments);
Usage experimentUsage();
int experimentCommand(const Arguments& arguments);

} // namespace hexapose
