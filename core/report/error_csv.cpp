// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/number_text.h"
#include "core/base/unit_text.h"
#include "core/base/units.h"
#include "core/report/error_report.h"

#include <array>
#include <chrono>
#include <cmath>
#include <string_view>

namespace hexapose {

namespace {

constexpr std::array<std::string_view, 6> kCoordinates{"x", "y", "z", "alpha", "beta", "gamma"};

std::string join(std::string_view before, std::size_t coordinate, std::string_view after,
                 std::array<std::string_view, 2> units) {
    std::string name(before);
    name += kCoordinates[coordinate];
    name += after;
    name += units[coordinate < 3 ? 0 : 1];
    return name + ',';
}

std::string header() {
    constexpr std::array<std::string_view, 2> kTable{"_mm", "_deg"};
    constexpr std::array<std::string_view, 2> kSi{"_m", "_rad"};
    std::string line = "number,";
    for (const std::string_view after : {"_target", "", "_error"})
        for (std::size_t i = 0; i < kCoordinates.size(); ++i)
            line += join("", i, after, kTable);
    for (std::size_t i = 0; i < kCoordinates.size(); ++i)
        line += join("error_", i, "", kSi);
    for (const std::string_view after : {"_bound", "_sigma"})
        for (std::size_t i = 0; i < kCoordinates.size(); ++i)
            line += join("", i, after, kTable);
    return line + "status,iterations,residual_mm,l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm,measurements,start_s\n";
}

void appendTableUnits(const PoseVector& values, std::string& line) {
    for (int i = 0; i < 6; ++i)
        line += (i < 3 ? mmText(values[i]) : degText(values[i])) + ',';
}

void appendSi(const PoseVector& values, std::string& line) {
    for (const double value : values)
        line += (std::isfinite(value) ? formatNumber(value) : std::string()) + ',';
}

std::string csvRow(const ErrorRow& row) {
    const PoseVector unknown = PoseVector::Constant(std::nan(""));
    const bool usable = row.solution.isUsable();
    std::string line = std::to_string(row.number) + ',';
    appendTableUnits(row.sample.target.toVector(), line);
    appendTableUnits(usable ? row.solution.pose.toVector() : unknown, line);
    appendTableUnits(usable ? row.error : unknown, line);
    appendSi(usable ? row.error : unknown, line);
    appendTableUnits(row.predictedBound, line);
    appendTableUnits(row.predictedSigma, line);
    line += std::string(toWord(row.solution.status)) + ',' + std::to_string(row.solution.iterations) + ',';
    if (std::isfinite(row.solution.residual))
        line += formatNumber(mmFromMetres(row.solution.residual));
    line += ',';
    for (const double length : row.sample.meanLengths)
        line += mmText(length) + ',';
    const double start = std::chrono::duration<double>(row.sample.start).count();
    return line + std::to_string(row.sample.measurements) + ',' + formatFixed(start, 6) + '\n';
}

} // namespace

std::string formatErrorCsv(const ErrorReport& report) {
    std::string text = header();
    for (const ErrorRow& row : report.rows)
        text += csvRow(row);
    return text;
}

} // namespace hexapose
