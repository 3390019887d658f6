// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/reduction.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hexapose {

namespace {

constexpr double kPauseSteps = 5.0;

/// One run of rows in a view.
class RunReducer {
public:
    RunReducer(const Column& column, const TimeAxis& time, const TimeView& view, const TimeAxis::Run& run,
               std::vector<PixelColumn>& out)
        : m_values(column.numbers()), m_column(column), m_time(time), m_view(view), m_run(run), m_out(out) {}

    void reduce() {
        const Row begin = m_time.firstAtOrAfter(m_run, m_view.begin);
        const Row end = m_time.firstAfter(m_run, m_view.end);
        m_gap = true;
        if (const auto before = valueBefore(begin))
            put(-1, *before, *before + 1, *before + 1 != begin);
        const double scale = m_view.pixels / (m_view.end - m_view.begin);
        for (Row row = begin; row < end;) {
            const int pixel = pixelOf(m_time.seconds(row), scale);
            Row next = pixel + 1 >= m_view.pixels
                           ? end
                           : std::min(end, m_time.firstAtOrAfter({row, end}, timeOf(pixel + 1, scale)));
            next = std::max(next, row + 1);
            put(pixel, row, next, false);
            row = next;
        }
        if (const auto after = valueAfter(end))
            put(m_view.pixels, *after, *after + 1, *after != end);
    }

private:
    int pixelOf(double seconds, double scale) const {
        if (std::isnan(seconds)) // a row without a time is drawn nowhere of its own
            return m_out.empty() ? 0 : std::clamp(m_out.back().pixel, 0, m_view.pixels - 1);
        return std::clamp(static_cast<int>((seconds - m_view.begin) * scale), 0, m_view.pixels - 1);
    }
    double timeOf(int pixel, double scale) const { return m_view.begin + pixel / scale; }

    std::optional<Row> valueBefore(Row row) const {
        while (row > m_run.begin && std::isnan(m_time.seconds(row - 1)))
            --row;
        if (row == m_run.begin || std::isnan(m_values[row - 1]))
            return std::nullopt;
        return row - 1;
    }
    std::optional<Row> valueAfter(Row row) const {
        while (row < m_run.end && std::isnan(m_time.seconds(row)))
            ++row;
        if (row == m_run.end || std::isnan(m_values[row]))
            return std::nullopt;
        return row;
    }

    /// The rows [begin, end) become a pixel column. Missing cells at their ends break the lines to the
    /// neighbours; one between them does not show at this size unless nothing is left.
    void put(int pixel, Row begin, Row end, bool apart) {
        Row first = begin, last = end;
        while (first < end && std::isnan(m_values[first]))
            ++first;
        if (first == end) {
            m_gap = true;
            return;
        }
        while (std::isnan(m_values[last - 1]))
            --last;
        --last;
        const MinMax extremes = m_column.range(first, last + 1);
        PixelColumn drawn{pixel,          m_values[first],       extremes.min,         extremes.max,
                          m_values[last], m_time.seconds(first), m_time.seconds(last), false};
        const bool pause = !m_out.empty() && m_time.usualStep() > 0.0 &&
                           drawn.firstTime - m_out.back().lastTime > kPauseSteps * m_time.usualStep();
        drawn.gapBefore = m_gap || apart || first != begin || pause;
        m_out.push_back(drawn);
        m_gap = last + 1 != end;
    }

    const Chunked<double>& m_values;
    const Column& m_column;
    const TimeAxis& m_time;
    const TimeView& m_view;
    const TimeAxis::Run& m_run;
    std::vector<PixelColumn>& m_out;
    bool m_gap = true;
};

} // namespace

std::vector<PixelColumn> reduceToPixels(const Column& column, const TimeAxis& time, const TimeView& view) {
    std::vector<PixelColumn> out;
    if (!column.isNumber() || view.pixels < 1 || !(view.end > view.begin))
        return out;
    for (const TimeAxis::Run& run : time.runs())
        RunReducer(column, time, view, run, out).reduce();
    return out;
}

} // namespace hexapose
