// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <utility>

namespace hexapose {

/// Elimination with partial pivoting, in place: the matrix becomes its factors, the columns of `right` the
/// solutions. Allocates nothing. Returns the determinant; 0 or NaN where there is no solution.
template <class Right>
double solveInPlace(Eigen::MatrixXd& matrix, Right&& right) noexcept {
    const Eigen::Index size = matrix.rows();
    double determinant = 1.0;
    for (Eigen::Index k = 0; k < size; ++k) {
        Eigen::Index pivot = 0;
        matrix.col(k).tail(size - k).cwiseAbs().maxCoeff(&pivot);
        pivot += k;
        if (pivot != k) {
            matrix.row(k).swap(matrix.row(pivot));
            right.row(k).swap(right.row(pivot));
            determinant = -determinant;
        }
        determinant *= matrix(k, k);
        if (!(determinant != 0.0))
            return determinant;
        const Eigen::Index below = size - k - 1;
        matrix.col(k).tail(below) /= matrix(k, k);
        for (Eigen::Index j = k + 1; j < size; ++j)
            matrix.col(j).tail(below) -= matrix(k, j) * matrix.col(k).tail(below);
        for (Eigen::Index j = 0; j < right.cols(); ++j)
            right.col(j).tail(below) -= right(k, j) * matrix.col(k).tail(below);
    }
    for (Eigen::Index j = 0; j < right.cols(); ++j)
        for (Eigen::Index k = size - 1; k >= 0; --k) {
            right(k, j) /= matrix(k, k);
            right.col(j).head(k) -= right(k, j) * matrix.col(k).head(k);
        }
    return determinant;
}

} // namespace hexapose
