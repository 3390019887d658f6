// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace hexapose {

/// Singular values of a step matrix at home below this part of the largest count as zero.
inline constexpr double kRankTolerance = 1e-8;

/// Why these equations do not determine the unknowns: not square, or which equation follows from which. ""
/// when they do. Rows of `matrix` are the equations, without units; `names` has one name a row, `unknowns`
/// one a column.
std::string rankFault(const Eigen::MatrixXd& matrix, const std::vector<std::string>& names,
                      const std::vector<std::string>& unknowns);

} // namespace hexapose
