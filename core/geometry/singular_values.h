// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace hexapose {

/// The singular values of a matrix, the largest first, by Eigen's two-sided Jacobi rotations, which keep the
/// small ones accurate. One place for all: this is the slowest part of Eigen to compile. The entries are
/// finite numbers.
Eigen::Matrix<double, 6, 1> singularValues(const Eigen::Matrix<double, 6, 6>& matrix);
/// Of any shape; allocates.
Eigen::VectorXd singularValues(const Eigen::MatrixXd& matrix);

} // namespace hexapose
