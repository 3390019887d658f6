// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/exhibit.h"

#include <string_view>
#include <vector>

namespace hexapose::reproduce {

/// A table or figure by its word on the command line.
struct ExhibitMaker {
    const char* name;
    Exhibit (*make)(Experiment& experiment, const Progress& progress);
};

/// In the order of the papers.
const std::vector<ExhibitMaker>& exhibitMakers();

Exhibit makeTable2(Experiment& experiment, const Progress& progress);
Exhibit makeTable3(Experiment& experiment, const Progress& progress);
Exhibit makeTable4(Experiment& experiment, const Progress& progress);
Exhibit makeTable5(Experiment& experiment, const Progress& progress);
Exhibit makeFigure3(Experiment& experiment, const Progress& progress);
Exhibit makeFigure5(Experiment& experiment, const Progress& progress);
// Of the second paper, Front. Mech. Eng. 2025, 20(1):7, on the same platform.
Exhibit makeFigure13(Experiment& experiment, const Progress& progress);
Exhibit makeFigure15(Experiment& experiment, const Progress& progress);
Exhibit makeFigure16(Experiment& experiment, const Progress& progress);

} // namespace hexapose::reproduce
