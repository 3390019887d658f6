// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hexapose {

/// A column's name, taken apart: "l1_mm", "l1 [mm]" and "l1 (mm)" are l1 in mm.
struct LabelAndUnit {
    std::string label, unit;
};
LabelAndUnit splitUnit(std::string_view name);

/// The usual spelling of a unit: "mm" for "MM" or "millimeter"; nothing for text that is none.
std::optional<std::string> unitFromText(std::string_view text);

/// What a number of this unit is to be multiplied by to be SI (m, rad, s); nothing for other units.
std::optional<double> toSi(std::string_view unit);

} // namespace hexapose
