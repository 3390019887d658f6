// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/exhibit.h"

#include <optional>
#include <string>

namespace hexapose::reproduce {

inline constexpr std::size_t kTextColumns = 120;

/// All but the times; the same on every run.
std::string exhibitText(const Exhibit& exhibit);
/// The times; "" where there are none.
std::string timesText(const Exhibit& exhibit);
/// "Checks: 35 of 36 hold (rule)."; "" where nothing is checked.
std::string checksText(const Exhibit& exhibit);

/// The checks one by one, where they are few.
std::optional<Block> checksBlock(const Exhibit& exhibit);

/// Said wherever times are shown.
inline constexpr const char* kAboutTimes =
    "Times of 10,000 solutions: the paper's are MATLAB on an i7-8750H, ours compiled code on one core of "
    "this "
    "machine. For comparison only: they are not checked, and differ from run to run.";

} // namespace hexapose::reproduce
