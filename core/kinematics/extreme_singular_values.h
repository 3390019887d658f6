// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <optional>

namespace hexapose {

struct ExtremeSingularValues {
    double smallest = 0.0;
    double largest = 0.0;
};

/// The smallest and the largest singular value of a 6x6 matrix, each to 1e-12 of the largest, a tenth of the
/// time that all six take. The entries are finite, and neither so large nor so small that their twelfth power
/// is none.
ExtremeSingularValues extremeSingularValues(const Eigen::Matrix<double, 6, 6>& matrix) noexcept;

/// Their fast computation alone, from the characteristic polynomial; nothing where that does not know them so
/// well: singular or nearly, or more than two nearly the same.
std::optional<ExtremeSingularValues>
fastExtremeSingularValues(const Eigen::Matrix<double, 6, 6>& matrix) noexcept;

} // namespace hexapose
