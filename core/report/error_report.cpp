// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/report/error_report.h"

#include "core/kinematics/pose_accuracy.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace hexapose {

namespace {

double wrapped(double angle) {
    return std::remainder(angle, 2.0 * std::numbers::pi);
}

ForwardResult solve(const ForwardSolver& solver, const SettledSample& sample) {
    const ForwardResult fromHome = solver.solve(sample.meanLengths, Pose{});
    if (fromHome.isUsable())
        return fromHome;
    const ForwardResult fromTarget = solver.solve(sample.meanLengths, sample.target);
    return fromTarget.isUsable() ? fromTarget : fromHome;
}

ErrorStatistics statisticsOf(const std::vector<ErrorRow>& rows) {
    ErrorStatistics statistics;
    double count = 0.0;
    for (const ErrorRow& row : rows) {
        if (!row.solution.isUsable())
            continue;
        count += 1.0;
        statistics.mean += row.error;
        statistics.rms += row.error.cwiseAbs2();
        statistics.maximum = statistics.maximum.cwiseMax(row.error.cwiseAbs());
    }
    if (count == 0.0)
        statistics.maximum.setConstant(std::numeric_limits<double>::quiet_NaN());
    statistics.mean /= count; // 0 / 0 is the "nothing to take it over" that is meant
    statistics.rms = (statistics.rms / count).cwiseSqrt();
    return statistics;
}

} // namespace

ErrorReport makeErrorReport(const PlatformGeometry& geometry, const ForwardSolver& solver,
                            const std::vector<SettledSample>& samples, double resolution) {
    ErrorReport report;
    report.platformName = geometry.name;
    report.solver = solver.name();
    report.resolution = resolution;
    for (const SettledSample& sample : samples) {
        ErrorRow row;
        row.number = static_cast<int>(report.rows.size()) + 1;
        row.sample = sample;
        row.solution = solve(solver, sample);
        const RoundingEffect rounding = roundingEffect(geometry, row.sample.target, resolution);
        row.predictedBound = rounding.bound;
        row.predictedSigma = rounding.sigma;
        if (row.solution.isUsable()) {
            row.error = row.solution.pose.toVector() - sample.target.toVector();
            row.error.tail<3>() = row.error.tail<3>().unaryExpr(&wrapped).eval();
        } else {
            row.error.setConstant(std::numeric_limits<double>::quiet_NaN());
            ++report.failed;
        }
        report.rows.push_back(row);
    }
    report.statistics = statisticsOf(report.rows);
    return report;
}

PoseVector largestPredictedBound(const ErrorReport& report) {
    PoseVector largest =
        PoseVector::Constant(report.rows.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0);
    for (const ErrorRow& row : report.rows)
        largest = largest.cwiseMax(row.predictedBound);
    return largest;
}

} // namespace hexapose
