// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/analysis/solve_again.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <thread>

namespace hexapose {

namespace {

constexpr Row kRunRows = Row{1} << 14;

void solveRun(const Table& table, const SixColumns& lengths, const std::optional<SixColumns>& pose,
              const ForwardSolver& solver, Row begin, std::vector<SolvedRows::Solution>& out) {
    const Row end = std::min<Row>(begin + kRunRows, out.size());
    Pose start = pose ? poseOf(table, *pose, begin).value_or(Pose{}) : Pose{};
    for (Row row = begin; row < end; ++row) {
        const auto measured = lengthsOf(table, lengths, row);
        if (!measured)
            continue;
        const ForwardResult result = solver.solve(*measured, start);
        out[row] = {result.pose, result.status, result.isUsable(), true};
        if (result.isUsable())
            start = result.pose;
    }
}

/// Of two angles, in (-pi, pi].
double turnBetween(double a, double b) {
    return std::remainder(a - b, 2.0 * std::numbers::pi);
}

} // namespace

SolvedRows solveAgain(const Table& table, const SixColumns& lengths, const ForwardSolver& solver,
                      const SolveAgainOptions& options) {
    SolvedRows solved;
    solved.rows.resize(table.rowCount());
    const std::optional<SixColumns> pose = findMeasuredPose(table);
    const Row runs = (table.rowCount() + kRunRows - 1) / kRunRows;
    std::atomic<Row> next{0}, done{0};
    const auto work = [&] {
        for (Row run = next++; run < runs && !options.stop.stop_requested(); run = next++) {
            solveRun(table, lengths, pose, solver, run * kRunRows, solved.rows);
            if (options.onProgress)
                options.onProgress(static_cast<double>(++done) / static_cast<double>(runs));
        }
    };
    const unsigned count =
        options.threads > 0 ? static_cast<unsigned>(options.threads) : std::thread::hardware_concurrency();
    {
        std::vector<std::jthread> others;
        for (unsigned i = 1; i < count && i < runs; ++i)
            others.emplace_back(work);
        work();
    }
    if (options.stop.stop_requested())
        solved.rows.clear();
    return solved;
}

std::vector<Disagreement> findDisagreements(const Table& table, const SixColumns& pose,
                                            const SolvedRows& solved, const AgreementTolerance& tolerance) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<Disagreement> found;
    for (Row row = 0; row < solved.rows.size(); ++row) {
        const SolvedRows::Solution& solution = solved.rows[row];
        if (!solution.hasLengths)
            continue;
        const std::optional<Pose> recorded = poseOf(table, pose, row);
        if (recorded.has_value() != solution.isUsable) {
            found.push_back({row, std::nullopt, kNone, kNone, solution.status, solution.isUsable});
            continue;
        }
        if (!recorded)
            continue;
        const PoseVector a = recorded->toVector(), b = solution.pose.toVector();
        for (Eigen::Index i = 0; i < 6; ++i) {
            const double difference = i < 3 ? a[i] - b[i] : turnBetween(a[i], b[i]);
            if (std::abs(difference) <= (i < 3 ? tolerance.offset : tolerance.angle))
                continue;
            const auto k = static_cast<std::size_t>(i);
            found.push_back(
                {row, pose.columns[k], a[i] / pose.toSi[k], b[i] / pose.toSi[k], solution.status, true});
        }
    }
    return found;
}

} // namespace hexapose
