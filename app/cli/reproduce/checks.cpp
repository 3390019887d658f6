// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/checks.h"

#include "app/cli/reproduce/printed.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace hexapose::reproduce {

namespace {

constexpr double kErrorPart = 0.25;
constexpr double kNewtonPart = 0.03;
constexpr double kMprNewtonPart = 0.10;

/// What the paper's iteration is known for, and what the exact Jacobian takes to 1e-10 m in its place.
constexpr double kIterationsPerDecade = 1.39;
constexpr double kExactNewtonIterations = 4.3;
constexpr double kExactMprNewtonIterations = 2.7;

constexpr int kShownDigits = 6;

} // namespace

bool Check::holds() const {
    return std::abs(measured - expected) <= allowed;
}

std::string Check::text() const {
    return what + ": " + inDigits(measured, kShownDigits) + ", expected " + inDigits(expected, kShownDigits) +
           " within " + inDigits(allowed, kShownDigits);
}

std::vector<Check> errorChecks(const std::vector<ErrorMeasurement>& table2) {
    std::vector<Check> checks;
    for (const ErrorMeasurement& row : table2)
        for (std::size_t k = 0; k < kCoordinates.size(); ++k) {
            const Printed entry = printed(row.published.digits[k], row.published.exponent);
            checks.push_back(
                {title(row.published) + ", " + kCoordinates[k].name + " (" + kCoordinates[k].unit + ")",
                 entry.value, row.measured.meanError[kCoordinates[k].index],
                 std::max(kErrorPart * entry.value, 0.5 * entry.lastDigit)});
        }
    return checks;
}

std::vector<Check> iterationChecks(const std::vector<ErrorMeasurement>& table3) {
    std::vector<Check> checks;
    for (const ErrorMeasurement& row : table3) {
        const double part = row.published.algorithm == Algorithm::Newton ? kNewtonPart : kMprNewtonPart;
        // The paper's total is of as many poses as its test set has.
        const double expected =
            static_cast<double>(row.published.iterations) * row.measured.poses / published::kTestPoses;
        checks.push_back({title(row.published) + ", iterations", expected,
                          static_cast<double>(row.measured.iterations), part * expected});
    }
    return checks;
}

std::vector<Check> stopChecks(const std::vector<StopMeasurement>& table4) {
    const auto slope = [&](StopMethod StopMeasurement::*method) {
        return iterationsPerDecade(
            table4, [&](const StopMeasurement& row) { return (row.*method).measured.meanIterations(); });
    };
    const StopMeasurement& finest = table4.back();
    return {
        {"Newton, iterations a decade", kIterationsPerDecade, slope(&StopMeasurement::newton),
         kNewtonPart * kIterationsPerDecade},
        {"MPR-NR, iterations a decade", kIterationsPerDecade, slope(&StopMeasurement::mprNewton),
         kMprNewtonPart * kIterationsPerDecade},
        {"Newton, exact Jacobian, iterations to 1e-10 m", kExactNewtonIterations,
         finest.newton.exact.meanIterations(), kNewtonPart * kExactNewtonIterations},
        {"MPR-NR, exact Jacobian, iterations to 1e-10 m", kExactMprNewtonIterations,
         finest.mprNewton.exact.meanIterations(), kMprNewtonPart * kExactMprNewtonIterations},
    };
}

std::size_t holding(const std::vector<Check>& checks) {
    return static_cast<std::size_t>(
        std::count_if(checks.begin(), checks.end(), [](const Check& check) { return check.holds(); }));
}

} // namespace hexapose::reproduce
