// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/number_rows.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

NumberRows::NumberRows(const CsvTable& table, const std::array<std::string_view, 6>& columns)
    : m_fieldCount(table.header.size()) {
    std::transform(columns.begin(), columns.end(), m_columns.begin(),
                   [&](std::string_view name) { return table.requireColumn(name); });
}

std::optional<Eigen::Matrix<double, 6, 1>> NumberRows::read(const CsvTable::Row& row) const {
    for (std::size_t i = m_fieldCount; i < row.fields.size(); ++i)
        if (!row.fields[i].empty())
            return std::nullopt;
    Eigen::Matrix<double, 6, 1> values;
    for (int k = 0; k < 6; ++k) {
        const std::optional<double> value =
            parseNumber(CsvTable::field(row, m_columns[static_cast<std::size_t>(k)]));
        if (!value || !std::isfinite(*value))
            return std::nullopt;
        values[k] = *value;
    }
    return values;
}

std::vector<CsvTable::Row> everyRow(const CsvTable& table) {
    std::vector<CsvTable::Row> rows = table.rows;
    if (table.halfWritten)
        rows.push_back(*table.halfWritten);
    return rows;
}

} // namespace hexapose
