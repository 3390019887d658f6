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

/// Statistics of the errors of each coordinate; m and rad, order x y z alpha beta gamma. Not a number when
/// there is nothing to take them over: no error would look like a perfect one.
struct ErrorStatistics {
    PoseVector mean = PoseVector::Zero(); ///< signed mean
    PoseVector rms = PoseVector::Zero();
    PoseVector maximum = PoseVector::Zero(); ///< of the absolute value
};

/// Lengths are commonly reported with one decimal of a millimetre, m.
inline constexpr double kLengthResolution = 1e-4;

/// One row of the report, as Table 5: reference, solved, error, and what the length resolution alone
/// explains.
struct ErrorRow {
    int number = 0; ///< 1, 2, ...
    SettledSample sample;
    ForwardResult solution;
    PoseVector error = PoseVector::Zero(); ///< solved - target, angles wrapped to +-pi
    /// sum_i |J^-1|_ki r/2: worst case of rounding to r. Infinite where the target is singular.
    PoseVector predictedBound = PoseVector::Zero();
    PoseVector predictedSigma =
        PoseVector::Zero(); ///< standard deviation of the same rounding, r/sqrt(12) a leg
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

/// The largest predicted bound of each coordinate over the samples; not a number without samples.
PoseVector largestPredictedBound(const ErrorReport& report);

/// Solves each sample (from home, as the method does; from the target where that gives nothing usable) and
/// compares.
ErrorReport makeErrorReport(const PlatformGeometry& geometry, const ForwardSolver& solver,
                            const std::vector<SettledSample>& samples, double resolution = kLengthResolution);

/// errors.csv: one row a sample. Columns: number; target (x_target_mm ... gamma_target_deg); solved (x_mm ...
/// gamma_deg); error in the same units (x_error_mm ... gamma_error_deg) and in SI (error_x_m ...
/// error_gamma_rad); predicted bound and standard deviation (x_bound_mm ..., x_sigma_mm ...); status,
/// iterations, residual_mm; mean lengths l1_mm ... l6_mm, measurements, start_s. Solved and error are empty
/// without a usable solution.
std::string formatErrorCsv(const ErrorReport& report);

/// `count` poses, seeded, uniform within +-range, every one inside the strokes and clear of singularities
/// (drawn again otherwise). Ranges in m and rad. Throws InputError for a range that is negative or not
/// finite, and when the strokes leave nothing of it.
std::vector<Pose> randomPoses(const PlatformGeometry& geometry, int count, double offsetRange,
                              double angleRange, std::uint64_t seed);

/// The default list: within +-10 mm and +-10 deg, or the half of both, the half of that ... where a machine's
/// strokes leave nothing of them. Throws InputError for a machine that can hardly move from home.
std::vector<Pose> defaultPoses(const PlatformGeometry& geometry, int count, std::uint64_t seed);

} // namespace hexapose
