// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/column.h"
#include "core/table/problem.h"
#include "core/table/time_axis.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

/// A log, or any CSV, as columns: all of it, or the part that has been read so far. A value: copies share
/// the cells, and nothing of it changes once it is made.
class Table {
public:
    const std::string& sourceName() const { return m_sourceName; }
    Row rowCount() const { return m_rowCount; }
    const std::vector<Column>& columns() const { return m_columns; }
    /// By name ("l1_mm"), else by label ("l1") where one column alone has it.
    std::optional<std::size_t> find(std::string_view nameOrLabel) const;
    const TimeAxis& time() const { return m_time; }
    const ProblemList& problems() const { return m_problems; }

    /// A row that is known to stand at a place of the text; those behind it follow line by line, up to the
    /// next one that is known.
    struct RowPlace {
        Row row = 0;
        long line = 0;            ///< 1-based
        std::uint64_t offset = 0; ///< in bytes of the text (TextSource)
    };
    /// The last known place at or before a row.
    RowPlace placeBefore(Row row) const;
    long lineOf(Row row) const;
    const std::string& headerText() const { return m_headerText; }

private:
    friend class TableBuilder;
    std::string m_sourceName;
    std::string m_headerText; ///< the file's own, without its line end
    Row m_rowCount = 0;
    std::vector<Column> m_columns;
    TimeAxis m_time;
    ProblemList m_problems;
    std::vector<RowPlace> m_places; ///< of the first row of each block
};

} // namespace hexapose
