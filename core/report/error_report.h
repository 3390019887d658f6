// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"
#include "core/kinematics/forward_solver.h"
#include "core/report/settled_sample.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hexapose {

/// Statistics of the absolute errors of each coordinate; m and rad, order x y z alpha beta gamma.
struct ErrorStatistics {
    PoseVector mean = PoseVector::Zero();    ///< signed mean
    PoseVector rms = PoseVector::Zero();
    PoseVector maximum = PoseVector::Zero(); ///< of the absolute value
};

/// One row of the report, as Table 5: reference, solved, error, and what the length resolution alone explains.
struct ErrorRow {
    int number = 0; ///< 1, 2, ...
    SettledSample sample;
    ForwardResult solution;
    PoseVector error = PoseVector::Zero();          ///< solved - target, angles wrapped to +-pi
    PoseVector predictedBound = PoseVector::Zero(); ///< sum_i |J^-1|_ki r/2: worst case of rounding to r
    PoseVector predictedSigma = PoseVector::Zero(); ///< standard deviation of the same rounding, r/sqrt(12) a leg
};

/// The error report of Figure 8: rows, statistics over the rows whose solution is usable.
struct ErrorReport {
    std::string platformName;
    std::string solver;
    double resolution = 0.0; ///< r, m
    std::vector<ErrorRow> rows;
    int failed = 0; ///< rows without a usable solution; they are in rows but not in the statistics
    ErrorStatistics statistics;
};

ErrorReport makeErrorReport(const PlatformGeometry& geometry, const ForwardSolver& solver,
                            const std::vector<SettledSample>& samples, double resolution = 1e-4);

/// errors.csv: one row a sample: number, target, solved, error, predicted bound and sigma (x_mm ... and *_deg), status,
/// iterations, residual_mm, mean lengths; then nothing else. SI columns error_*_m / error_*_rad are there too.
std::string formatErrorCsv(const ErrorReport& report);

/// The default list of attitudes: `count` poses, seeded, uniform within +-range, every one inside the strokes
/// (drawn again otherwise). Ranges in m and rad.
std::vector<Pose> randomAttitudes(const PlatformGeometry& geometry, int count, double offsetRange, double angleRange,
                                  std::uint64_t seed);

} // namespace hexapose
