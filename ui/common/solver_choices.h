// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace hexapose {

/// The solvers that a console can run its loop with, by their words, the usual one first: those that refine,
/// and finite-step integration.
inline constexpr std::array<std::string_view, 4> kSolverChoices{"mpr3-nr", "mpr2-nr", "newton", "fsi"};

inline bool isSolverChoice(std::string_view word) {
    return std::find(kSolverChoices.begin(), kSolverChoices.end(), word) != kSolverChoices.end();
}

} // namespace hexapose
