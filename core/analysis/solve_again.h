// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/analysis/six_columns.h"
#include "core/kinematics/forward_solver.h"

#include <functional>
#include <stop_token>
#include <vector>

namespace hexapose {

/// Solutions of the recorded lengths of a table, row by row.
struct SolvedRows {
    struct Solution {
        Pose pose; ///< NaN where there is none
        SolveStatus status = SolveStatus::InvalidInput;
        bool isUsable = false;
        bool hasLengths = false;
    };
    std::vector<Solution> rows; ///< fewer than the table has where it was stopped
};

struct SolveAgainOptions {
    int threads = 0; ///< 0: one for each processor
    std::stop_token stop;
    std::function<void(double part)> onProgress; ///< from any of the threads
};

/// Solves each row that has all six lengths, on several threads. A row starts from the pose before, as the
/// control loop does; the first one, and the first of each run of 2^14 rows, from the recorded pose, or from
/// home where there is none. So the result does not depend on the number of threads.
SolvedRows solveAgain(const Table& table, const SixColumns& lengths, const ForwardSolver& solver,
                      const SolveAgainOptions& options = {});

/// A recorded value that its lengths do not give.
struct Disagreement {
    Row row = 0;
    std::optional<std::size_t> column;   ///< of the table; empty: one has a usable pose, the other none
    double recorded = 0.0, solved = 0.0; ///< in the column's unit; NaN where there is none
    SolveStatus status = SolveStatus::InvalidInput; ///< of the solution
    bool isSolved = false;                          ///< the solution has a usable pose
};

struct AgreementTolerance {
    double offset = 1e-9; ///< m
    double angle = 1e-8;  ///< rad
};

/// Where the recorded poses differ from solutions by more than the tolerance, row by row. Angles are compared
/// modulo a turn.
std::vector<Disagreement> findDisagreements(const Table& table, const SixColumns& pose,
                                            const SolvedRows& solved,
                                            const AgreementTolerance& tolerance = {});

} // namespace hexapose
