// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/column.h"

#include <limits>

namespace hexapose {

double Column::number(Row row, std::int64_t origin) const {
    switch (m_info.kind) {
    case CellKind::Number:
        return m_numbers[row];
    case CellKind::Time: {
        const std::int64_t time = m_times[row];
        if (time != kNoTime)
            return secondsBetween(origin, time);
        break;
    }
    case CellKind::Word:
        break;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

std::string_view Column::word(Row row) const {
    return m_info.kind == CellKind::Word ? m_words.at(m_codes[row]) : std::string_view();
}

} // namespace hexapose
