// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/nice_ticks.h"
#include "ui/viewer/table_marks.h"

#include <chrono>
#include <map>
#include <optional>
#include <vector>

namespace hexapose {

/// What the charts of a page show: one time for all, and the values of those that were zoomed by hand.
struct PageView {
    TimeSpan time;
    std::map<int, AxisRange> values; ///< by the id of a chart
    bool isWhole = true;             ///< all there is, also of what is still being read

    bool operator==(const PageView&) const = default;
};

/// The views of a page, back and forward. A burst of steps of one kind is one entry.
class ViewHistory {
public:
    using Time = std::chrono::steady_clock::time_point;
    enum class Step { Single, Burst };

    const PageView& view() const { return m_views[m_at]; }
    void show(const PageView& view, Step step, Time now);
    /// In place of the present view: it grows with its file.
    void replace(const PageView& view) { m_views[m_at] = view; }
    bool canGoBack() const { return m_at > 0; }
    bool canGoForward() const { return m_at + 1 < m_views.size(); }
    void goBack();
    void goForward();

private:
    std::vector<PageView> m_views{PageView()};
    std::size_t m_at = 0;
    std::optional<Time> m_lastBurst;
};

} // namespace hexapose
