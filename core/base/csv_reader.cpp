// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/csv_reader.h"

#include "core/base/input_error.h"

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <system_error>
#include <utility>

namespace hexapose {

namespace {

constexpr int kEnd = -1;

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool isBlank(const CsvTable::Row& row) {
    return row.fields.size() == 1 && trimmed(row.fields.front()).empty();
}

} // namespace

CsvReader::CsvReader(std::istream& in, std::string sourceName)
    : m_in(in), m_sourceName(std::move(sourceName)) {
    skipByteOrderMark();
    CsvTable::Row row;
    Ending ending = Ending::Nothing;
    do {
        ending = readRecord(row);
        if (ending == Ending::Nothing)
            throw InputError(InputFault{InputFault::Kind::Empty, m_sourceName});
        if (ending == Ending::InsideQuote)
            throw InputError(InputFault{InputFault::Kind::OpenQuote, m_sourceName, row.line});
    } while (isBlank(row));
    for (const std::string& name : row.fields)
        m_header.push_back(trimmed(name));
}

bool CsvReader::next(CsvTable::Row& row) {
    for (;;) {
        const Ending ending = readRecord(row);
        if (ending == Ending::Nothing)
            return false;
        if (isBlank(row))
            continue;
        const bool torn = ending == Ending::InsideQuote ||
                          (ending == Ending::EndOfFile && row.fields.size() < m_header.size());
        if (!torn)
            return true;
        if (ending == Ending::InsideQuote && m_line != row.line)
            throw InputError(InputFault{InputFault::Kind::OpenQuote, m_sourceName, row.line});
        m_halfWritten = row;
        return false;
    }
}

std::string CsvReader::halfWrittenWarning() const {
    return m_sourceName + ":" + std::to_string(m_halfWritten ? m_halfWritten->line : 0) +
           ": half-written last line left out";
}

int CsvReader::peek() {
    if (m_position == m_filled) {
        m_in.read(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
        if (m_in.bad())
            throw InputError(InputFault{InputFault::Kind::NotReadFurther, m_sourceName, m_line});
        m_filled = static_cast<std::size_t>(m_in.gcount());
        m_position = 0;
        if (m_filled == 0)
            return kEnd;
    }
    return static_cast<unsigned char>(m_buffer[m_position]);
}

int CsvReader::take() {
    const int c = peek();
    if (c != kEnd)
        ++m_position;
    return c;
}

bool CsvReader::atLineEnd() {
    const int c = peek();
    return c == '\n' || c == '\r';
}

void CsvReader::takeLineEnd() {
    if (take() == '\r' && peek() == '\n')
        take();
    ++m_line;
}

void CsvReader::skipByteOrderMark() {
    const int first = peek();
    if (first == 0xFF || first == 0xFE)
        throw InputError(InputFault{InputFault::Kind::NotUtf8, m_sourceName, 1});
    if (m_filled >= 3 && first == 0xEF && m_buffer[1] == '\xBB' && m_buffer[2] == '\xBF')
        m_position = 3;
}

/// After the opening quote; false when the file ends before the closing one.
bool CsvReader::readQuoted(std::string& field) {
    for (;;) {
        const int c = take();
        if (c == kEnd)
            return false;
        if (c == '"') {
            if (peek() != '"')
                return true;
            take();
        } else if (c == '\n') {
            ++m_line;
        }
        field += static_cast<char>(c);
    }
}

CsvReader::Ending CsvReader::readRecord(CsvTable::Row& row) {
    row.line = m_line;
    if (peek() == kEnd) {
        row.fields.clear();
        return Ending::Nothing;
    }
    std::size_t count = 0;
    const auto nextField = [&]() -> std::string& {
        if (count == row.fields.size())
            row.fields.emplace_back();
        std::string& field = row.fields[count++];
        field.clear();
        return field;
    };
    Ending ending = Ending::Line;
    std::string* field = &nextField();
    bool atStart = true;
    for (;;) {
        if (atLineEnd()) {
            takeLineEnd();
            break;
        }
        const int c = take();
        if (c == kEnd) {
            ending = Ending::EndOfFile;
            break;
        }
        if (c == '"' && atStart) {
            if (!readQuoted(*field)) {
                ending = Ending::InsideQuote;
                break;
            }
        } else if (c == ',') {
            field = &nextField();
            atStart = true;
            continue;
        } else {
            *field += static_cast<char>(c);
        }
        atStart = false;
    }
    row.fields.resize(count);
    return ending;
}

CsvSource::CsvSource(const std::filesystem::path& file) {
    if (file == "-") {
        m_standardInput = &std::cin;
        m_name = "standard input";
        return;
    }
    m_name = file.string();
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw InputError(InputFault{InputFault::Kind::Directory, m_name});
    errno = 0;
    m_file = std::make_unique<std::ifstream>(file, std::ios::binary);
    if (!*m_file)
        throw InputError(
            InputFault{InputFault::Kind::NotRead, m_name, 0, {std::generic_category().message(errno)}});
}

} // namespace hexapose
