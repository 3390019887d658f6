// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>

namespace hexapose {

/// Part of the solvers' inside. Six linear equations by columns: six of coefficients, then the right-hand
/// side.
using LinearSystem = std::array<Eigen::Array<double, 6, 1>, 7>;

/// Gauss-Jordan elimination with partial pivoting, in place. Works on whole columns and leaves the rows where
/// they are, so that every operation is a short vector one. Returns the determinant; x is the solution where
/// that is neither zero nor NaN.
inline double solveLinearSystem(LinearSystem& columns, Eigen::Matrix<double, 6, 1>& x) noexcept {
    Eigen::Array<double, 6, 1> unused = Eigen::Array<double, 6, 1>::Ones();
    std::array<Eigen::Index, 6> pivotRow{};
    double determinant = 1.0;
    for (std::size_t k = 0; k < 6; ++k) {
        Eigen::Index row = 0;
        (columns[k].abs() * unused).maxCoeff(&row);
        const double pivot = columns[k][row];
        determinant *= pivot;
        if (!(determinant != 0.0))
            return 0.0;
        // An odd number of rows jumped over is an odd number of swaps.
        if ((static_cast<int>(unused.head(row).sum()) & 1) != 0)
            determinant = -determinant;
        unused[row] = 0.0;
        pivotRow[k] = row;
        Eigen::Array<double, 6, 1> factor = columns[k] * (1.0 / pivot);
        factor[row] = 0.0;
        for (std::size_t j = k + 1; j < 7; ++j)
            columns[j] -= factor * columns[j][row];
        columns[k][row] = pivot;
    }
    for (std::size_t k = 0; k < 6; ++k)
        x[static_cast<Eigen::Index>(k)] = columns[6][pivotRow[k]] / columns[k][pivotRow[k]];
    return determinant;
}

} // namespace hexapose
