// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kinematics/forward_solver.h"
#include "core/record/snapshot.h"
#include "ui/common/theme.h"

#include <QString>

#include <array>
#include <string_view>

namespace hexapose {

QString stateText(RunState state);
/// The same where it is known: not with old data, nor of a sender that reports none.
QString stateText(const Snapshot& snapshot);
Tone stateTone(const Snapshot& snapshot);
/// Why nothing can be run now, though something is connected; empty when it can.
QString runInhibit(const Snapshot& snapshot);
/// The same, but for a stop or fault that must be cleared.
QString linkInhibit(const Snapshot& snapshot);
Tone stateTone(RunState state);
QString solveStatusText(SolveStatus status);
/// "MPR3-NR" of "mpr3-nr"; the word itself when it is not known.
QString solverTitle(std::string_view word);

/// The six pose coordinates in their usual order: how the screen writes them, how they are called where a
/// screen reader speaks them ("alpha"), and their unit.
struct CoordinateText {
    QString symbol;
    QString word;
    QString unit;
    bool angle;
};
const std::array<CoordinateText, 6>& coordinateTexts();

/// From SI to what the screen shows: mm or degrees.
double toDisplay(int coordinate, double si);
double fromDisplay(int coordinate, double shown);
/// measured - target as shown; angles wrapped to +-180 degrees.
double displayError(int coordinate, double measured, double target);

} // namespace hexapose
