// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace hexapose {

/// The last samples of several channels over time, in a ring. NaN is a gap in one channel. A value: copying
/// it freezes it.
class ChartHistory {
public:
    explicit ChartHistory(std::size_t channels, std::size_t capacity = 24000);

    /// Times must not go back; a sample that would is left out. `values` has one number a channel.
    void add(double time, const std::vector<double>& values);
    /// The curves are broken here.
    void addGap();
    void clear();

    std::size_t size() const { return m_size; }
    double lastTime() const; ///< 0 when empty

    /// One channel in a window of time, and one sample beyond each border, so that the curve runs to the
    /// edge. NaN is a gap.
    std::vector<QPointF> curve(std::size_t channel, double from, double to) const;
    std::optional<std::pair<double, double>> range(std::size_t channel, double from, double to) const;
    /// The newest value at or before a time; NaN for none.
    double valueAt(std::size_t channel, double time) const;

private:
    std::size_t slot(std::size_t index) const { return (m_begin + index) % m_capacity; }
    double timeOf(std::size_t index) const { return m_times[slot(index)]; }
    double valueOf(std::size_t index, std::size_t channel) const {
        return m_values[slot(index) * m_channels + channel];
    }
    std::size_t firstFrom(double time) const; ///< index of the first sample not before it
    void push(double time, const double* values);

    std::size_t m_channels;
    std::size_t m_capacity;
    std::size_t m_begin = 0;
    std::size_t m_size = 0;
    std::vector<double> m_times;
    std::vector<double> m_values;
};

} // namespace hexapose
