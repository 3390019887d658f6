// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table.h"
#include "ui/common/theme.h"
#include "ui/plot/plot.h"

#include <vector>

namespace hexapose {

/// A range of time, s.
struct TimeSpan {
    double begin = 0.0, end = 1.0;
    double length() const { return end - begin; }
    bool operator==(const TimeSpan&) const = default;
};

/// Where the states of a log change (its column `state`), and its events (`event`): found once, row by row
/// as the table grows.
class TableMarks {
public:
    void follow(const Table& table);
    /// What shows in a view that is so many pixels wide.
    std::vector<Plot::Span> spans(const Table& table, const TimeSpan& view, int pixels,
                                  const ThemeColors& colors) const;
    std::vector<Plot::Instant> instants(const Table& table, const TimeSpan& view, int pixels) const;

private:
    struct Change {
        Row row;
        std::uint32_t code;
    };
    std::optional<std::size_t> m_state, m_event; ///< columns
    std::vector<Change> m_changes;
    std::vector<Change> m_events;
    Row m_rows = 0;
};

} // namespace hexapose
