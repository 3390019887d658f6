// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/record_scanner.h"

namespace hexapose {

bool RecordScanner::next() {
    if (m_next >= m_text.size())
        return false;
    m_begin = m_next;
    m_line = m_nextLine;
    m_fields.assign(1, {});
    m_hasLineEnd = false;
    bool inQuote = false, atStart = true;
    std::size_t i = m_begin;
    for (; i < m_text.size(); ++i) {
        const char c = m_text[i];
        if (inQuote) {
            const bool twice = c == '"' && i + 1 < m_text.size() && m_text[i + 1] == '"';
            if (c == '"' && !twice) {
                inQuote = false;
                continue;
            }
            i += twice ? 1 : 0;
            m_nextLine +=
                c == '\n' || (c == '\r' && (i + 1 == m_text.size() || m_text[i + 1] != '\n')) ? 1 : 0;
            m_fields.back() += c;
        } else if (c == '"' && atStart) {
            inQuote = true;
            atStart = false;
            m_fields.back().clear(); // of blanks before it
        } else if (c == m_separator) {
            m_fields.emplace_back();
            atStart = true;
        } else if (c == '\n' || c == '\r') {
            m_hasLineEnd = true;
            break;
        } else {
            atStart = atStart && c == ' ';
            m_fields.back() += c;
        }
    }
    m_end = i;
    m_isClosed = !inQuote;
    if (m_hasLineEnd) {
        i += m_text[i] == '\r' && i + 1 < m_text.size() && m_text[i + 1] == '\n' ? 2U : 1U;
        ++m_nextLine;
    }
    m_next = i;
    return true;
}

bool RecordScanner::isBlank() const {
    return text().find_first_not_of(" \t") == std::string_view::npos;
}

} // namespace hexapose
