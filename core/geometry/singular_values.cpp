// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/geometry/singular_values.h"

#include <Eigen/SVD>

namespace hexapose {

Eigen::Matrix<double, 6, 1> singularValues(const Eigen::Matrix<double, 6, 6>& matrix) {
    return Eigen::JacobiSVD<Eigen::Matrix<double, 6, 6>>(matrix).singularValues();
}

Eigen::VectorXd singularValues(const Eigen::MatrixXd& matrix) {
    return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
}

} // namespace hexapose
