// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/table_marks.h"

#include "ui/viewer/qt_text.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr int kShade = 20; ///< of 255, so that curves stand out
constexpr int kStrongShade = 36;

std::optional<std::size_t> wordColumn(const Table& table, std::string_view name) {
    const auto index = table.find(name);
    return index && table.columns()[*index].info().kind == CellKind::Word ? index : std::nullopt;
}

QColor shaded(QColor colour, int shade) {
    colour.setAlpha(shade);
    return colour;
}

/// As the console's lamp has it; of a state that it does not know, light and dark in turn.
QColor colourOf(std::string_view state, std::uint32_t code, const ThemeColors& colors) {
    if (state == "fault")
        return shaded(colors.bad, kStrongShade);
    if (state == "stopped")
        return shaded(colors.warn, kStrongShade);
    if (state == "moving")
        return shaded(colors.accent, kStrongShade);
    if (state == "settling")
        return shaded(colors.accent, kShade);
    if (state == "enabled")
        return shaded(colors.good, kShade);
    return shaded(colors.idle, code % 2 == 0 ? kShade : kShade / 2);
}

} // namespace

void TableMarks::follow(const Table& table) {
    if (m_rows == 0 || table.rowCount() < m_rows) {
        *this = TableMarks();
        m_state = wordColumn(table, "state");
        m_event = wordColumn(table, "event");
    }
    const Column* state = m_state ? &table.columns()[*m_state] : nullptr;
    const Column* event = m_event ? &table.columns()[*m_event] : nullptr;
    for (Row row = m_rows; row < table.rowCount(); ++row) {
        if (state != nullptr) {
            const std::uint32_t code = state->code(row);
            if (m_changes.empty() || m_changes.back().code != code)
                m_changes.push_back({row, code});
        }
        if (event != nullptr) {
            const std::uint32_t code = event->code(row);
            if (code != 0)
                m_events.push_back({row, code});
        }
    }
    m_rows = table.rowCount();
}

std::vector<Plot::Span> TableMarks::spans(const Table& table, const TimeSpan& view, int pixels,
                                          const ThemeColors& colors) const {
    std::vector<Plot::Span> spans;
    if (!m_state)
        return spans;
    const Column& states = table.columns()[*m_state];
    const TimeAxis& time = table.time();
    const double pixel = view.length() / std::max(1, pixels);
    const Row before = time.lastAtOrBefore(view.begin).value_or(0);
    auto change = std::upper_bound(m_changes.begin(), m_changes.end(), before,
                                   [](Row row, const Change& one) { return row < one.row; });
    if (change != m_changes.begin())
        --change;
    double drawn = -HUGE_VAL;
    for (; change != m_changes.end(); ++change) {
        const double begin = time.seconds(change->row);
        const double end = change + 1 != m_changes.end() ? time.seconds((change + 1)->row) : time.end();
        if (begin > view.end && time.runs().size() == 1)
            break;
        if (change->code == 0 || !(end > begin) || end < view.begin || end < drawn + pixel)
            continue; // too short to be seen beside what is drawn already
        drawn = end;
        const std::string_view word = states.wordOf(change->code);
        spans.push_back({begin, end, toQt(word), colourOf(word, change->code, colors)});
    }
    return spans;
}

std::vector<Plot::Instant> TableMarks::instants(const Table& table, const TimeSpan& view, int pixels) const {
    std::vector<Plot::Instant> instants;
    if (!m_event)
        return instants;
    const Column& events = table.columns()[*m_event];
    const TimeAxis& time = table.time();
    const double pixel = view.length() / std::max(1, pixels);
    const bool isOrdered = time.runs().size() == 1;
    auto event = m_events.begin();
    if (isOrdered)
        event = std::lower_bound(m_events.begin(), m_events.end(),
                                 time.firstAtOrAfter(time.runs().front(), view.begin),
                                 [](const Change& one, Row row) { return one.row < row; });
    for (; event != m_events.end(); ++event) {
        const double at = time.seconds(event->row);
        if (at > view.end && isOrdered)
            break;
        if (!(at >= view.begin && at <= view.end))
            continue;
        if (!instants.empty() && at >= instants.back().x && at < instants.back().x + pixel)
            continue; // in the same pixel
        instants.push_back({at, toQt(events.wordOf(event->code))});
    }
    std::stable_sort(instants.begin(), instants.end(),
                     [](const Plot::Instant& a, const Plot::Instant& b) { return a.x < b.x; });
    return instants;
}

} // namespace hexapose
