// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace hexapose {

/// Exit statuses of the command line's contract.
inline constexpr int kExitDone = 0;
inline constexpr int kExitSomeFailed = 1;
inline constexpr int kExitBadInput = 2;

// Each command takes the words after its name and returns the exit status; bad usage or input is an
// InputError.
int inverseCommand(const QStringList& arguments);
int forwardCommand(const QStringList& arguments);
int trainCommand(const QStringList& arguments);
int simulateCommand(const QStringList& arguments);
int runCommand(const QStringList& arguments);
int reportCommand(const QStringList& arguments);
int experimentCommand(const QStringList& arguments);
int summaryCommand(const QStringList& arguments);
int verifyCommand(const QStringList& arguments);
int compareCommand(const QStringList& arguments);
int trackCommand(const QStringList& arguments);
int reproduceCommand(const QStringList& arguments);

} // namespace hexapose
