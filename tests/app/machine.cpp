// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/app/machine.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <random>

namespace hexapose::apptest {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Rz Ry Rx b, written out.
Point rotate(const Six& pose, const Point& b) {
    const double ca = std::cos(pose[3] * kDegree), sa = std::sin(pose[3] * kDegree);
    const double cb = std::cos(pose[4] * kDegree), sb = std::sin(pose[4] * kDegree);
    const double cg = std::cos(pose[5] * kDegree), sg = std::sin(pose[5] * kDegree);
    return {cg * cb * b[0] + (cg * sb * sa - sg * ca) * b[1] + (cg * sb * ca + sg * sa) * b[2],
            sg * cb * b[0] + (sg * sb * sa + cg * ca) * b[1] + (sg * sb * ca - cg * sa) * b[2],
            -sb * b[0] + cb * sa * b[1] + cb * ca * b[2]};
}

Point onRing(double radius, double degrees, double z) {
    return {radius * std::cos(degrees * kDegree), radius * std::sin(degrees * kDegree), z};
}

std::string list(const Point& point) {
    std::string text = "[";
    for (const double value : point)
        text += (text.size() > 1 ? ", " : "") + shortest(value);
    return text + "]";
}

/// Numbers of a generator that every library draws alike.
class Draw {
public:
    explicit Draw(std::uint32_t seed) : m_engine(seed) {}
    double within(double range) {
        return range * (2.0 * (static_cast<double>(m_engine()) / 4294967296.0) - 1.0);
    }

private:
    std::mt19937 m_engine;
};

} // namespace

std::string shortest(double value) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    return {text.data(), end.ptr};
}

std::string Machine::toml() const {
    std::string text = "format = 1\nname = \"" + name + "\"\n[home]\nposition_mm = " + list(home) + "\n";
    for (std::size_t i = 0; i < 6; ++i)
        text += "[[leg]]\nbase_mm = " + list(base[i]) + "\nplatform_mm = " + list(platform[i]) +
                "\nmin_mm = " + shortest(minMm) + "\nmax_mm = " + shortest(maxMm) + "\n";
    return text;
}

Six Machine::lengths(const Six& pose) const {
    Six result{};
    for (std::size_t i = 0; i < 6; ++i) {
        const Point turned = rotate(pose, platform[i]);
        double square = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            square += std::pow(home[k] + pose[k] + turned[k] - base[i][k], 2);
        result[i] = std::sqrt(square);
    }
    return result;
}

std::vector<Six> Machine::poses(int count, double rangeMm, double rangeDeg, std::uint32_t seed) const {
    Draw draw(seed);
    std::vector<Six> result;
    while (static_cast<int>(result.size()) < count) {
        Six pose{};
        for (std::size_t k = 0; k < 6; ++k)
            pose[k] = draw.within(k < 3 ? rangeMm : rangeDeg);
        const Six legs = lengths(pose);
        if (std::all_of(legs.begin(), legs.end(), [&](double l) { return l > minMm && l < maxMm; }))
            result.push_back(pose);
    }
    return result;
}

Machine laboratory() {
    Machine machine{"Laboratory platform", {0.0, 0.0, 272.9}, {}, {}, 250.0, 350.0};
    machine.base = {{{-25, 184, 52.5},
                     {25, 184, 52.5},
                     {171.85, -70.35, 52.5},
                     {146.85, -113.65, 52.5},
                     {-146.85, -113.65, 52.5},
                     {-171.85, -70.35, 52.5}}};
    machine.platform = {{{-84.01, 74.49, 52.5},
                         {84.01, 74.49, 52.5},
                         {106.51, 35.51, 52.5},
                         {22.5, -110, 52.5},
                         {-22.5, -110, 52.5},
                         {-106.51, 35.51, 52.5}}};
    return machine;
}

Machine octahedral() {
    Machine machine{"Octahedron", {0.0, 0.0, 420.0}, {}, {}, 350.0, 700.0};
    for (std::size_t i = 0; i < 6; ++i) {
        const auto pair = static_cast<double>(i / 2);
        const auto nextPair = static_cast<double>(((i + 1) / 2) % 3);
        machine.base[i] = onRing(300.0, 120.0 * pair, 0.0);
        machine.platform[i] = onRing(200.0, 120.0 * nextPair - 60.0, 0.0);
    }
    return machine;
}

Machine irregular(std::uint32_t seed) {
    Draw draw(seed);
    Machine machine = laboratory();
    machine.name = "Irregular";
    machine.minMm = 180.0;
    machine.maxMm = 460.0;
    for (auto* ring : {&machine.base, &machine.platform})
        for (Point& joint : *ring)
            for (double& value : joint)
                value = std::round(value + draw.within(12.0));
    return machine;
}

Machine scaled(Machine machine, double factor) {
    const auto scale = [factor](Point& point) {
        for (double& value : point)
            value *= factor;
    };
    scale(machine.home);
    std::for_each(machine.base.begin(), machine.base.end(), scale);
    std::for_each(machine.platform.begin(), machine.platform.end(), scale);
    machine.minMm *= factor;
    machine.maxMm *= factor;
    machine.name += " scaled";
    return machine;
}

std::string csv(const std::vector<std::string>& columns, const std::vector<Six>& rows) {
    std::string text;
    for (const std::string& column : columns)
        text += (text.empty() ? "" : ",") + column;
    text += "\n";
    for (const Six& row : rows)
        for (std::size_t k = 0; k < 6; ++k)
            text += shortest(row[k]) + (k < 5 ? "," : "\n");
    return text;
}

} // namespace hexapose::apptest
