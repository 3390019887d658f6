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

std::vector<QPointF> ChartHistory::curve(std::size_t channel, double from, double to) const {
    std::size_t begin = firstFrom(from);
    std::size_t end = firstFrom(std::nextafter(to, std::numeric_limits<double>::infinity()));
    begin = begin > 0 ? begin - 1 : 0;
    end = std::min(end + 1, m_size);
    std::vector<QPointF> points;
    points.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
        points.emplace_back(timeOf(i), valueOf(i, channel));
    }
    return points;
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
