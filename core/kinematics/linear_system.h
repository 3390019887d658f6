// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <utility>

namespace hexapose {

/// Six linear equations, one a row: six coefficients, then the right-hand side.
using LinearSystem = std::array<std::array<double, 7>, 6>;

/// Gaussian elimination with partial pivoting, in place. Returns the determinant; x is the solution where
/// that is neither zero nor NaN.
inline double solveLinearSystem(LinearSystem& m, std::array<double, 6>& x) noexcept {
    double determinant = 1.0;
    for (std::size_t k = 0; k < 6; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < 6; ++i)
            if (std::abs(m[i][k]) > std::abs(m[pivot][k]))
                pivot = i;
        if (pivot != k) {
            std::swap(m[pivot], m[k]);
            determinant = -determinant;
        }
        determinant *= m[k][k];
        if (!(determinant != 0.0))
            return 0.0;
        const double inverse = 1.0 / m[k][k];
        for (std::size_t i = k + 1; i < 6; ++i) {
            const double factor = m[i][k] * inverse;
            for (std::size_t j = k + 1; j < 7; ++j)
                m[i][j] -= factor * m[k][j];
        }
        m[k][k] = inverse; // kept for the way back
    }
    for (std::size_t k = 6; k-- > 0;) {
        double sum = m[k][6];
        for (std::size_t j = k + 1; j < 6; ++j)
            sum -= m[k][j] * x[j];
        x[k] = sum * m[k][k];
    }
    return determinant;
}

} // namespace hexapose
