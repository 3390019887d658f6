// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/rank_check.h"

#include "core/geometry/singular_values.h"

#include <Eigen/QR>

#include <algorithm>

namespace hexapose {

namespace {

/// What is left of a unit row, beside the rows before it, when it follows from them.
constexpr double kDependent = 1e-7;
/// Coefficients below this are rounding: such a row takes no part.
constexpr double kTakesPart = 1e-6;
/// Of an unknown that no equation holds, every coefficient is below this.
constexpr double kLoose = 1e-12;

void addName(std::vector<std::string>& list, const std::string& name) {
    if (std::find(list.begin(), list.end(), name) == list.end())
        list.push_back(name);
}

std::string joined(const std::vector<std::string>& list) {
    std::string text;
    for (const std::string& name : list)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// Every equation that follows from those before it, with these; "" where none does by itself.
std::string dependences(const Eigen::MatrixXd& matrix, const std::vector<std::string>& names) {
    std::vector<Eigen::Index> kept;
    std::string text;
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
        Eigen::MatrixXd before(matrix.cols(), static_cast<Eigen::Index>(kept.size()));
        for (std::size_t i = 0; i < kept.size(); ++i)
            before.col(static_cast<Eigen::Index>(i)) = matrix.row(kept[i]).transpose();
        const Eigen::VectorXd own = matrix.row(row).transpose();
        Eigen::VectorXd parts = Eigen::VectorXd::Zero(before.cols());
        if (before.cols() > 0)
            parts = before.colPivHouseholderQr().solve(own);
        if ((own - before * parts).norm() > kDependent) {
            kept.push_back(row);
            continue;
        }
        std::vector<std::string> from;
        for (Eigen::Index i = 0; i < parts.size(); ++i)
            if (std::abs(parts[i]) > kTakesPart)
                addName(from, names[static_cast<std::size_t>(kept[static_cast<std::size_t>(i)])]);
        text += (text.empty() ? "" : "; ") + names[static_cast<std::size_t>(row)] +
                (from.empty() ? " says nothing" : " follows from " + joined(from));
    }
    return text;
}

} // namespace

std::string rankFault(const Eigen::MatrixXd& matrix, const std::vector<std::string>& names,
                      const std::vector<std::string>& unknowns) {
    const std::string equations = std::to_string(matrix.rows()) + " equations";
    if (!matrix.allFinite())
        return "two points that an equation keeps apart are one at home";
    const Eigen::VectorXd values = singularValues(matrix);
    const auto rank = (values.array() > kRankTolerance * values.maxCoeff()).count();
    const std::string rankText = "rank " + std::to_string(rank) + " at home";
    if (matrix.rows() != matrix.cols())
        return equations + " for " + std::to_string(matrix.cols()) + " unknowns: not square, " + rankText +
               (rank < matrix.rows() ? ": " + dependences(matrix, names) : "");
    if (rank == matrix.rows())
        return {};
    std::string which = dependences(matrix, names);
    if (which.empty())
        which = "they nearly depend on each other";
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
        if (matrix.col(column).cwiseAbs().maxCoeff() < kLoose)
            which += "; none holds " + unknowns[static_cast<std::size_t>(column)];
    return equations + " of " + rankText + ": " + which;
}

} // namespace hexapose
