// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// The records of a CSV text (RFC 4180): fields between separators, those that begin with a quote up to the
/// closing one; lines end with LF, CR LF or CR.
class RecordScanner {
public:
    RecordScanner(std::string_view text, char separator) : m_text(text), m_separator(separator) {}

    /// The next record, whose fields are without quotes; false at the end.
    bool next();
    const std::vector<std::string>& fields() const { return m_fields; }
    /// The record as it stands there, without its line end.
    std::string_view text() const { return m_text.substr(m_begin, m_end - m_begin); }
    std::size_t begin() const { return m_begin; } ///< of the record, in bytes
    long line() const { return m_line; }          ///< of its beginning, from 1
    std::size_t rest() const { return m_next; }   ///< where the following record begins
    long restLine() const { return m_nextLine; }
    bool hasLineEnd() const { return m_hasLineEnd; }
    bool isClosed() const { return m_isClosed; } ///< false: the text ends within a quoted field
    bool isBlank() const;

private:
    std::string_view m_text;
    char m_separator;
    std::vector<std::string> m_fields;
    std::size_t m_begin = 0, m_end = 0, m_next = 0;
    long m_line = 1, m_nextLine = 1;
    bool m_hasLineEnd = false, m_isClosed = true;
};

} // namespace hexapose
