// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapose {

ChartHistory::ChartHistory(std::size_t channels, std::size_t capacity)
    : m_channels(channels), m_capacity(std::max<std::size_t>(capacity, 1)), m_times(m_capacity),
      m_values(m_capacity * channels) {}

void ChartHistory::push(double time, const double* values) {
    if (m_size == m_capacity) {
        m_begin = slot(1);
        --m_size;
    }
    const std::size_t at = slot(m_size);
    m_times[at] = time;
    for (std::size_t c = 0; c < m_channels; ++c) {
        m_values[at * m_channels + c] =
            values == nullptr ? std::numeric_limits<double>::quiet_NaN() : values[c];
    }
    ++m_size;
}

void ChartHistory::add(double time, const std::vector<double>& values) {
    if (values.size() != m_channels || !std::isfinite(time) || (m_size > 0 && time < lastTime())) {
        return;
    }
    push(time, values.data());
}

void ChartHistory::addGap() {
    if (m_size > 0) {
        push(lastTime(), nullptr);
    }
}

void ChartHistory::clear() {
    m_begin = 0;
    m_size = 0;
}

double ChartHistory::lastTime() const {
    return m_size == 0 ? 0.0 : timeOf(m_size - 1);
}

std::size_t ChartHistory::firstFrom(double time) const {
    std::size_t low = 0;
    std::size_t high = m_size;
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (timeOf(middle) < time) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

namespace {

/// Collects one unbroken piece, group by group.
class Thinner {
public:
    Thinner(CurvePieces& pieces, std::size_t group) : m_pieces(pieces), m_group(group) {}

    void add(const QPointF& point) {
        if (m_pending.empty() && (m_pieces.empty() || m_broken)) {
            m_pieces.emplace_back();
            m_broken = false;
        }
        m_pending.push_back(point);
        if (m_pending.size() >= m_group) {
            flush();
        }
    }
    void endPiece() {
        flush();
        m_broken = true;
    }

private:
    void flush() {
        if (m_pending.empty()) {
            return;
        }
        auto& piece = m_pieces.back();
        if (m_group <= 2) {
            piece.insert(piece.end(), m_pending.begin(), m_pending.end());
        } else {
            const auto byY = [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); };
            auto [low, high] = std::minmax_element(m_pending.begin(), m_pending.end(), byY);
            piece.push_back(*std::min(low, high)); // in the order of time
            if (low != high) {
                piece.push_back(*std::max(low, high));
            }
        }
        m_pending.clear();
    }

    CurvePieces& m_pieces;
    std::size_t m_group;
    std::vector<QPointF> m_pending;
    bool m_broken = true;
};

} // namespace

CurvePieces ChartHistory::curve(std::size_t channel, double from, double to, std::size_t most) const {
    // One sample beyond each border, so that the curve runs to the edge.
    std::size_t begin = firstFrom(from);
    std::size_t end = firstFrom(std::nextafter(to, std::numeric_limits<double>::infinity()));
    begin = begin > 0 ? begin - 1 : 0;
    end = std::min(end + 1, m_size);
    CurvePieces pieces;
    if (end <= begin) {
        return pieces;
    }
    const std::size_t count = end - begin;
    const std::size_t group = count <= most ? 1 : 2 * ((count + most - 1) / most);
    Thinner thinner(pieces, group);
    for (std::size_t i = begin; i < end; ++i) {
        const double value = valueOf(i, channel);
        if (std::isfinite(value)) {
            thinner.add({timeOf(i), value});
        } else {
            thinner.endPiece();
        }
    }
    thinner.endPiece();
    return pieces;
}

std::optional<std::pair<double, double>> ChartHistory::range(std::size_t channel, double from,
                                                             double to) const {
    std::optional<std::pair<double, double>> found;
    for (std::size_t i = firstFrom(from); i < m_size && timeOf(i) <= to; ++i) {
        const double value = valueOf(i, channel);
        if (!std::isfinite(value)) {
            continue;
        }
        found = found ? std::pair(std::min(found->first, value), std::max(found->second, value))
                      : std::pair(value, value);
    }
    return found;
}

double ChartHistory::valueAt(std::size_t channel, double time) const {
    std::size_t index = firstFrom(std::nextafter(time, std::numeric_limits<double>::infinity()));
    return index == 0 ? std::numeric_limits<double>::quiet_NaN() : valueOf(index - 1, channel);
}

} // namespace hexapose
