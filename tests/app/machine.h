// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hexapose::apptest {

using Six = std::array<double, 6>; ///< x y z mm, alpha beta gamma deg; or six lengths, mm
using Point = std::array<double, 3>;

/// A platform as the tests know it: numbers in mm, its file, and lengths by the textbook's formula.
struct Machine {
    std::string name;
    Point home{};
    std::array<Point, 6> base{};
    std::array<Point, 6> platform{};
    double minMm = 0.0;
    double maxMm = 0.0;

    std::string toml() const;
    Six lengths(const Six& pose) const;
    /// Seeded poses within the ranges that no stroke forbids.
    std::vector<Six> poses(int count, double rangeMm, double rangeDeg, std::uint32_t seed) const;
};

/// Table 1 of Applied Sciences 2023, 13, 3082.
Machine laboratory();
/// Joints of each ring meet in pairs: three points below, three above, turned by 60 degrees.
Machine octahedral();
/// Joints drawn at random about an ordinary ring.
Machine irregular(std::uint32_t seed);
Machine scaled(Machine machine, double factor);

/// A CSV of poses, or of lengths, with all their digits.
std::string csv(const std::vector<std::string>& columns, const std::vector<Six>& rows);
std::string shortest(double value);

} // namespace hexapose::apptest
