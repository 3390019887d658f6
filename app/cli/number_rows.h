// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/csv_table.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace hexapose {

/// Six numbers a row, found by their column names.
class NumberRows {
public:
    /// Throws InputError when a column is missing.
    NumberRows(const CsvTable& table, const std::array<std::string_view, 6>& columns);
    /// Nothing when a number is missing, not finite, not a number at all, or when the row has not the
    /// header's number of fields (a decimal comma would otherwise shift the columns).
    std::optional<Eigen::Matrix<double, 6, 1>> read(const CsvTable::Row& row) const;

private:
    std::size_t m_fieldCount;
    std::array<std::size_t, 6> m_columns{};
};

/// Every row of the file, a last one without its line end too: each gets its answer.
std::vector<CsvTable::Row> everyRow(const CsvTable& table);

inline constexpr std::array<std::string_view, 6> kPoseColumns{"x_mm",      "y_mm",     "z_mm",
                                                              "alpha_deg", "beta_deg", "gamma_deg"};
inline constexpr std::array<std::string_view, 6> kLengthColumns{"l1_mm", "l2_mm", "l3_mm",
                                                                "l4_mm", "l5_mm", "l6_mm"};

} // namespace hexapose
