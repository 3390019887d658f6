// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/singularity.h"

#include "core/kinematics/extreme_singular_values.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <limits>

namespace hexapose {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Rows of a minor of three columns: all 20, in the order in which the n-th last has the rows that the n-th
/// has not. Their pairs of rows: all 15, in the same order.
struct Rows3 {
    std::size_t first, pair01, pair02, pair12, second, third;
    double sign; ///< in Laplace's expansion of the determinant by the first three columns
};

constexpr std::size_t pairIndex(std::size_t i, std::size_t j) {
    return i * 5 - i * (i + 1) / 2 + j - 1;
}

constexpr std::array<Rows3, 20> kTriples = [] {
    std::array<Rows3, 20> all{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = i + 1; j < 6; ++j)
            for (std::size_t k = j + 1; k < 6; ++k)
                all[n++] = {i,
                            pairIndex(i, j),
                            pairIndex(i, k),
                            pairIndex(j, k),
                            j,
                            k,
                            (i + j + k) % 2 != 0 ? 1.0 : -1.0};
    return all;
}();

} // namespace

double determinantOf(const Matrix6& matrix) noexcept {
    // The minors of the first three columns in one lane, those of the last three in the other.
    const auto both = [&](int column, std::size_t row) {
        const auto i = static_cast<Eigen::Index>(row);
        return Eigen::Array2d(matrix(i, column), matrix(i, column + 3));
    };
    std::array<Eigen::Array2d, 6> a, b, c;
    for (std::size_t i = 0; i < 6; ++i)
        a[i] = both(0, i), b[i] = both(1, i), c[i] = both(2, i);
    std::array<Eigen::Array2d, 15> pairs;
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = i + 1; j < 6; ++j)
            pairs[pairIndex(i, j)] = b[i] * c[j] - b[j] * c[i];
    std::array<Eigen::Array2d, 20> minors;
    for (std::size_t n = 0; n < 20; ++n) {
        const Rows3& rows = kTriples[n];
        minors[n] = a[rows.first] * pairs[rows.pair12] - a[rows.second] * pairs[rows.pair02] +
                    a[rows.third] * pairs[rows.pair01];
    }
    double determinant = 0.0;
    for (std::size_t n = 0; n < 20; ++n)
        determinant += kTriples[n].sign * minors[n][0] * minors[19 - n][1];
    return determinant;
}

SingularityMeasure singularityOf(const Matrix6& scaledJacobian) noexcept {
    const double determinant = determinantOf(scaledJacobian); // every element is multiplied there
    if (!std::isfinite(determinant))
        return {0.0, 0.0, std::numeric_limits<double>::infinity()};
    const ExtremeSingularValues values = extremeSingularValues(scaledJacobian);
    return {determinant, values.smallest, values.largest / values.smallest};
}

} // namespace hexapose
