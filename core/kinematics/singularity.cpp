// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/singularity.h"

#include "core/kinematics/extreme_singular_values.h"

#include <Eigen/Geometry>

#include <array>
#include <limits>

namespace hexapose {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Laplace's expansion by the first three columns: the rows of the minor there, and of the one beside it.
struct Term {
    std::array<int, 3> left, right;
    double sign;
};
constexpr std::array<Term, 20> kTerms{{
    {{0, 1, 2}, {3, 4, 5}, 1.0},  {{0, 1, 3}, {2, 4, 5}, -1.0}, {{0, 1, 4}, {2, 3, 5}, 1.0},
    {{0, 1, 5}, {2, 3, 4}, -1.0}, {{0, 2, 3}, {1, 4, 5}, 1.0},  {{0, 2, 4}, {1, 3, 5}, -1.0},
    {{0, 2, 5}, {1, 3, 4}, 1.0},  {{0, 3, 4}, {1, 2, 5}, 1.0},  {{0, 3, 5}, {1, 2, 4}, -1.0},
    {{0, 4, 5}, {1, 2, 3}, 1.0},  {{1, 2, 3}, {0, 4, 5}, -1.0}, {{1, 2, 4}, {0, 3, 5}, 1.0},
    {{1, 2, 5}, {0, 3, 4}, -1.0}, {{1, 3, 4}, {0, 2, 5}, -1.0}, {{1, 3, 5}, {0, 2, 4}, 1.0},
    {{1, 4, 5}, {0, 2, 3}, -1.0}, {{2, 3, 4}, {0, 1, 5}, 1.0},  {{2, 3, 5}, {0, 1, 4}, -1.0},
    {{2, 4, 5}, {0, 1, 3}, 1.0},  {{3, 4, 5}, {0, 1, 2}, -1.0},
}};

double minorOf(const Matrix6& m, const std::array<int, 3>& rows, int column) {
    const auto row = [&](std::size_t k) { return m.row(rows[k]).segment<3>(column); };
    return row(0)[0] * (row(1)[1] * row(2)[2] - row(1)[2] * row(2)[1]) +
           row(0)[1] * (row(1)[2] * row(2)[0] - row(1)[0] * row(2)[2]) +
           row(0)[2] * (row(1)[0] * row(2)[1] - row(1)[1] * row(2)[0]);
}

} // namespace

double determinantOf(const Matrix6& matrix) noexcept {
    double determinant = 0.0;
    for (const Term& term : kTerms)
        determinant += term.sign * minorOf(matrix, term.left, 0) * minorOf(matrix, term.right, 3);
    return determinant;
}

SingularityMeasure singularityOf(const Matrix6& scaledJacobian) noexcept {
    if (!scaledJacobian.allFinite())
        return {0.0, 0.0, std::numeric_limits<double>::infinity()};
    const ExtremeSingularValues values = extremeSingularValues(scaledJacobian);
    return {determinantOf(scaledJacobian), values.smallest, values.largest / values.smallest};
}

} // namespace hexapose
