// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/measurements.h"

#include <cmath>

namespace hexapose::reproduce {

namespace {

/// Table 4 averages more iterations than Tables 2 and 3 allow. Near the corners of set 2 the published
/// iteration needs some hundred.
constexpr int kUnhurried = 300;

} // namespace

std::vector<ErrorMeasurement> measureErrors(Experiment& experiment, std::span<const published::ErrorRow> rows,
                                            const Progress& progress) {
    std::vector<ErrorMeasurement> table;
    for (const published::ErrorRow& row : rows) {
        progress(static_cast<double>(table.size()) / static_cast<double>(rows.size()));
        ErrorMeasurement measurement{row, experiment.run({row.algorithm, row.set}), {}};
        if (row.algorithm != Algorithm::Mpr2 && row.algorithm != Algorithm::Mpr3)
            measurement.exact = experiment.run({row.algorithm, row.set, Jacobian::Exact});
        table.push_back(measurement);
    }
    return table;
}

std::vector<StopMeasurement> measureStops(Experiment& experiment, const Progress& progress) {
    std::vector<StopMeasurement> table;
    for (const published::StopRow& row : published::kTable4) {
        progress(static_cast<double>(table.size()) / static_cast<double>(published::kTable4.size()));
        const auto run = [&](Algorithm algorithm, Jacobian jacobian) {
            return experiment.run({algorithm, 2, jacobian, row.tolerance, kUnhurried});
        };
        table.push_back(
            {row.tolerance,
             {row.newtonDistance, row.newtonIterations, run(Algorithm::Newton, Jacobian::AsPublished),
              run(Algorithm::Newton, Jacobian::Exact)},
             {row.mprDistance, row.mprIterations, run(Algorithm::Mpr3Newton, Jacobian::AsPublished),
              run(Algorithm::Mpr3Newton, Jacobian::Exact)}});
    }
    return table;
}

double iterationsPerDecade(const std::vector<StopMeasurement>& rows, const StopValue& iterations) {
    const auto count = static_cast<double>(rows.size());
    double meanX = 0.0, meanY = 0.0;
    for (const StopMeasurement& row : rows) {
        meanX -= std::log10(row.tolerance) / count;
        meanY += iterations(row) / count;
    }
    double xy = 0.0, xx = 0.0;
    for (const StopMeasurement& row : rows) {
        const double x = -std::log10(row.tolerance) - meanX;
        xy += x * (iterations(row) - meanY);
        xx += x * x;
    }
    return xy / xx;
}

} // namespace hexapose::reproduce
