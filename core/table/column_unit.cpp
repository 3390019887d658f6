// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/column_unit.h"

#include "core/table/cell_text.h"

#include <algorithm>
#include <numbers>

namespace hexapose {

namespace {

struct Unit {
    std::string_view text, unit;
};

/// Case does not count, except that it is kept for what is not here.
constexpr Unit kUnits[] = {
    {"m", "m"},           {"meter", "m"},    {"metre", "m"},     {"mm", "mm"},         {"millimeter", "mm"},
    {"millimetre", "mm"}, {"cm", "cm"},      {"um", "um"},       {"\u00b5m", "um"},    {"\u03bcm", "um"},
    {"nm", "nm"},         {"in", "in"},      {"inch", "in"},     {"rad", "rad"},       {"mrad", "mrad"},
    {"urad", "urad"},     {"deg", "deg"},    {"degree", "deg"},  {"degrees", "deg"},   {"\u00b0", "deg"},
    {"s", "s"},           {"sec", "s"},      {"second", "s"},    {"seconds", "s"},     {"ms", "ms"},
    {"us", "us"},         {"\u00b5s", "us"}, {"\u03bcs", "us"},  {"ns", "ns"},         {"min", "min"},
    {"h", "h"},           {"hz", "Hz"},      {"khz", "kHz"},     {"percent", "%"},     {"%", "%"},
    {"v", "V"},           {"a", "A"},        {"n", "N"},         {"nm_torque", "N m"}, {"mm/s", "mm/s"},
    {"deg/s", "deg/s"},   {"m/s", "m/s"},    {"rad/s", "rad/s"}, {"mm_s", "mm/s"},
};

struct Factor {
    std::string_view unit;
    double factor;
};

constexpr Factor kFactors[] = {
    {"m", 1.0},     {"mm", 1e-3}, {"cm", 1e-2},   {"um", 1e-6},   {"nm", 1e-9},
    {"in", 0.0254}, {"rad", 1.0}, {"mrad", 1e-3}, {"urad", 1e-6}, {"deg", std::numbers::pi / 180.0},
    {"s", 1.0},     {"ms", 1e-3}, {"us", 1e-6},   {"ns", 1e-9},   {"min", 60.0},
    {"h", 3600.0}};

} // namespace

std::optional<std::string> unitFromText(std::string_view text) {
    text = trimmed(text);
    if (text.size() >= 2 &&
        ((text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')')))
        text = trimmed(text.substr(1, text.size() - 2));
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const Unit& unit : kUnits)
        if (unit.text == lower)
            return std::string(unit.unit);
    return std::nullopt;
}

LabelAndUnit splitUnit(std::string_view name) {
    name = trimmed(name);
    for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')}) {
        const std::size_t begin = name.rfind(open);
        if (begin == std::string_view::npos || begin == 0 || name.empty() || name.back() != close)
            continue;
        const std::string_view inside = name.substr(begin + 1, name.size() - begin - 2);
        const auto known = unitFromText(inside);
        if (known || open == '[') // brackets hold nothing else
            return {std::string(trimmed(name.substr(0, begin))),
                    known.value_or(std::string(trimmed(inside)))};
    }
    const std::size_t line = name.rfind('_');
    // A single letter is as often a name's own: "l1_set_m" is in metres, "axis_a" hardly in amperes.
    if (line != std::string_view::npos && line > 0) {
        const std::string_view end = name.substr(line + 1);
        const auto known = unitFromText(end);
        if (known && (end.size() > 1 || end == "m" || end == "s" || end == "%"))
            return {std::string(name.substr(0, line)), *known};
    }
    return {std::string(name), {}};
}

std::optional<double> toSi(std::string_view unit) {
    for (const Factor& factor : kFactors)
        if (factor.unit == unit)
            return factor.factor;
    return std::nullopt;
}

} // namespace hexapose
