// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/table.h"

#include <algorithm>

namespace hexapose {

std::optional<std::size_t> Table::find(std::string_view nameOrLabel) const {
    for (std::size_t i = 0; i < m_columns.size(); ++i)
        if (m_columns[i].info().name == nameOrLabel)
            return i;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        if (m_columns[i].info().label != nameOrLabel)
            continue;
        if (found)
            return std::nullopt;
        found = i;
    }
    return found;
}

Table::RowPlace Table::placeBefore(Row row) const {
    const auto after = std::upper_bound(m_places.begin(), m_places.end(), row,
                                        [](Row value, const RowPlace& place) { return value < place.row; });
    return after == m_places.begin() ? RowPlace{} : *(after - 1);
}

long Table::lineOf(Row row) const {
    const RowPlace place = placeBefore(row);
    return place.line + static_cast<long>(row - place.row);
}

} // namespace hexapose
