// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/table_builder.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace hexapose {

namespace {

constexpr std::size_t kStepsSampled = 4096;

template <typename T>
std::vector<void*> reserveIn(Chunked<T>& values, Row first, std::size_t count, bool huge) {
    values.reserve(first + count, huge);
    std::vector<void*> chunks;
    for (std::size_t i = first / kChunkRows; count > 0 && i <= (first + count - 1) / kChunkRows; ++i)
        chunks.push_back(values.writable(i));
    return chunks;
}

/// Values side by side into chunks, from a place in the first of them.
template <typename T>
void copyIn(const T* values, std::size_t count, const std::vector<void*>& chunks, std::size_t within) {
    for (void* const chunk : chunks) {
        const std::size_t size = std::min(count, kChunkRows - within);
        std::memcpy(static_cast<T*>(chunk) + within, values, size * sizeof(T));
        values += size;
        count -= size;
        within = 0;
    }
}

} // namespace

TableBuilder::TableBuilder(const TableFormat& format, std::string sourceName, bool huge)
    : m_wordCodes(format.columns.size()), m_format(format), m_huge(huge), m_nextLine(format.firstRowLine) {
    m_table.m_sourceName = std::move(sourceName);
    m_table.m_headerText = format.headerText;
    for (const ColumnInfo& info : format.columns)
        m_table.m_columns.emplace_back(info);
    TimeAxis& time = m_table.m_time;
    time.m_hasTime = format.timeColumn.has_value();
    time.m_column = format.timeColumn;
    time.m_isCalendar = format.timeIsCalendar;
    time.m_usualStep = time.m_hasTime ? 0.0 : 1.0;
    const auto report = [&](Problem::Kind kind, std::size_t column) {
        add({kind, std::max(1L, format.firstRowLine - 1), {}, format.columns[column].name});
    };
    for (const std::size_t column : format.renamed)
        report(Problem::Kind::RenamedColumn, column);
    for (const std::size_t column : format.unnamed)
        report(Problem::Kind::NoName, column);
}

TableBuilder::Reserved TableBuilder::begin(const ParsedRows& rows) {
    Reserved reserved;
    reserved.block = m_begun++;
    reserved.firstRow = m_reserved;
    reserved.rowCount = rows.rowCount;
    reserved.columns.resize(rows.columns.size());
    for (std::size_t i = 0; i < rows.columns.size(); ++i) {
        Reserved::Target& target = reserved.columns[i];
        Column& column = m_table.m_columns[i];
        switch (column.info().kind) {
        case CellKind::Number:
            target.chunks = reserveIn(column.m_numbers, m_reserved, rows.rowCount, m_huge);
            break;
        case CellKind::Time:
            target.chunks = reserveIn(column.m_times, m_reserved, rows.rowCount, m_huge);
            break;
        case CellKind::Word:
            target.chunks = reserveIn(column.m_codes, m_reserved, rows.rowCount, m_huge);
            for (const std::string& word : rows.columns[i].words) {
                const auto [known, isNew] = m_wordCodes[i].try_emplace(word, column.m_words.count() + 1);
                if (isNew)
                    column.m_words.append(word);
                target.codes.push_back(known->second);
            }
            break;
        }
    }
    reserved.places = rows.places;
    for (ParsedRows::Place& place : reserved.places) {
        place.row += m_reserved;
        place.line += m_nextLine;
    }
    reserved.problems = rows.problems;
    for (Problem& problem : reserved.problems)
        problem.line += m_nextLine;
    reserved.rowsLeftOut = rows.rowsLeftOut;
    reserved.cellsMissing = rows.cellsMissing;
    reserved.problemCount = rows.problemCount;
    m_reserved += rows.rowCount;
    m_nextLine += rows.lineCount;
    return reserved;
}

void TableBuilder::copy(const ParsedRows& rows, const Reserved& reserved, const TableFormat& format) {
    const std::size_t within = reserved.firstRow % kChunkRows;
    std::vector<std::uint32_t> codes;
    for (std::size_t i = 0; i < rows.columns.size(); ++i) {
        const ParsedRows::Cells& cells = rows.columns[i];
        const Reserved::Target& target = reserved.columns[i];
        switch (format.columns[i].kind) {
        case CellKind::Number:
            copyIn(cells.numbers.data(), rows.rowCount, target.chunks, within);
            break;
        case CellKind::Time:
            copyIn(cells.times.data(), rows.rowCount, target.chunks, within);
            break;
        case CellKind::Word:
            codes.assign(cells.codes.begin(),
                         cells.codes.begin() + static_cast<std::ptrdiff_t>(rows.rowCount));
            for (std::uint32_t& code : codes)
                code = code == 0 ? 0 : target.codes[code - 1];
            copyIn(codes.data(), rows.rowCount, target.chunks, within);
            break;
        }
    }
}

void TableBuilder::complete(Reserved reserved) {
    m_waiting.emplace(reserved.block, std::move(reserved));
    while (!m_waiting.empty() && m_waiting.begin()->first == m_appended) {
        append(m_waiting.begin()->second);
        m_waiting.erase(m_waiting.begin());
        ++m_appended;
    }
}

void TableBuilder::append(const Reserved& block) {
    const Row end = block.firstRow + block.rowCount;
    for (const ParsedRows::Place& place : block.places)
        m_table.m_places.push_back({place.row, place.line, place.offset});
    for (const Problem& problem : block.problems)
        add(problem);
    ProblemList& problems = m_table.m_problems;
    problems.count += block.problemCount - block.problems.size();
    problems.rowsLeftOut += block.rowsLeftOut;
    problems.cellsMissing += block.cellsMissing;
    for (Column& column : m_table.m_columns)
        if (column.isNumber())
            column.m_pyramid.grow(column.m_numbers, end);
    m_table.m_rowCount = end;
    followTime(block.firstRow, end);
}

void TableBuilder::add(Problem problem) {
    ++m_table.m_problems.count;
    if (m_table.m_problems.first.size() < ProblemList::kMost)
        m_table.m_problems.first.push_back(std::move(problem));
}

/// The runs in which time does not go back, and what there is to say of it.
void TableBuilder::followTime(Row begin, Row end) {
    TimeAxis& axis = m_table.m_time;
    axis.m_rowCount = end;
    if (axis.m_runs.empty())
        axis.m_runs.push_back({0, 0});
    axis.m_runs.back().end = end;
    if (!axis.m_hasTime) {
        axis.m_end = end > 0 ? static_cast<double>(end - 1) : 0.0;
        return;
    }
    const Column& column = m_table.m_columns[*axis.m_column];
    axis.m_times = column.m_times;
    const std::size_t sampled = m_steps.size();
    for (Row row = begin; row < end; ++row) {
        const std::int64_t time = column.m_times[row];
        if (time == kNoTime)
            continue;
        if (m_lastTime == kNoTime) {
            m_earliest = m_latest = time;
            axis.m_originNs = axis.m_isCalendar ? time : 0;
        } else if (time < m_lastTime) {
            add({Problem::Kind::TimeGoesBack, m_table.lineOf(row), column.info().name});
            axis.m_runs.back().end = row;
            axis.m_runs.push_back({row, end});
        } else if (time == m_lastTime) {
            add({Problem::Kind::TimeRepeated, m_table.lineOf(row), column.info().name});
        } else if (m_steps.size() < kStepsSampled) {
            std::int64_t step = 0;
            if (!__builtin_sub_overflow(time, m_lastTime, &step))
                m_steps.push_back(step);
        }
        m_earliest = std::min(m_earliest, time);
        m_latest = std::max(m_latest, time);
        m_lastTime = time;
    }
    if (m_lastTime == kNoTime)
        return;
    axis.m_begin = secondsBetween(axis.m_originNs, m_earliest);
    axis.m_end = secondsBetween(axis.m_originNs, m_latest);
    if (m_steps.size() != sampled) {
        std::vector<std::int64_t> steps = m_steps;
        const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
        std::nth_element(steps.begin(), middle, steps.end());
        axis.m_usualStep = 1e-9 * static_cast<double>(*middle);
    }
}

} // namespace hexapose
