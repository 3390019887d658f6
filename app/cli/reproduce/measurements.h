// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/experiment.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace hexapose::reproduce {

/// Told the part done, 0 to 1, now and then.
using Progress = std::function<void(double)>;

/// One row of Table 2 or 3.
struct ErrorMeasurement {
    published::ErrorRow published;
    MethodRun measured;             ///< with the iteration as published
    std::optional<MethodRun> exact; ///< with the exact Jacobian; nothing where there is no iteration
};

std::vector<ErrorMeasurement> measureErrors(Experiment& experiment, std::span<const published::ErrorRow> rows,
                                            const Progress& progress);

/// One method in one row of Table 4.
struct StopMethod {
    double publishedDistance;
    double publishedIterations;
    MethodRun measured;
    MethodRun exact;
};
struct StopMeasurement {
    double tolerance;
    StopMethod newton;
    StopMethod mprNewton; ///< cubic
};

/// Table 4 and Figure 5: set 2, one stop test a decade.
std::vector<StopMeasurement> measureStops(Experiment& experiment, const Progress& progress);

/// What a row of Table 4 says of one method.
using StopValue = std::function<double(const StopMeasurement&)>;

/// Slope of the straight line through the iterations over -log10 D(L).
double iterationsPerDecade(const std::vector<StopMeasurement>& rows, const StopValue& iterations);

} // namespace hexapose::reproduce
