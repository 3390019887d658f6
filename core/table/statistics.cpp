// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/statistics.h"

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr std::size_t kBlock = 1024;

/// Count, mean and sum of squared deviations, and of squares; two of them join without loss (Chan, Golub
/// and LeVeque, 1983).
struct Moments {
    double count = 0.0, mean = 0.0, deviations = 0.0;

    void add(const Moments& other) {
        if (other.count == 0.0)
            return;
        const double sum = count + other.count;
        const double step = other.mean - mean;
        mean += step * (other.count / sum);
        deviations += other.deviations + step * step * (count * other.count / sum);
        count = sum;
    }
};

/// Of some values side by side: the first pass finds the mean, relative to the first value, the second the
/// deviations.
Moments momentsOf(const double* values, std::size_t size) {
    Moments moments;
    std::size_t begin = 0;
    while (begin < size && std::isnan(values[begin]))
        ++begin;
    if (begin == size)
        return moments;
    const double base = values[begin];
    double sum = 0.0;
    for (std::size_t i = begin; i < size; ++i) {
        if (!std::isnan(values[i])) {
            sum += values[i] - base;
            ++moments.count;
        }
    }
    moments.mean = base + sum / moments.count;
    for (std::size_t i = begin; i < size; ++i) {
        if (!std::isnan(values[i])) {
            const double deviation = values[i] - moments.mean;
            moments.deviations += deviation * deviation;
        }
    }
    return moments;
}

} // namespace

Statistics statisticsOf(const Column& column, const std::vector<RowRange>& rows) {
    Statistics result;
    if (!column.isNumber())
        return result;
    const Chunked<double>& values = column.numbers();
    Moments moments;
    MinMax extremes;
    for (const RowRange& range : rows) {
        for (Row row = range.begin; row < range.end;) {
            const std::size_t within = row % kChunkRows;
            const std::size_t size = std::min({kBlock, range.end - row, kChunkRows - within});
            const Moments block = momentsOf(values.chunk(row / kChunkRows) + within, size);
            moments.add(block);
            result.missing += size - static_cast<std::size_t>(block.count);
            row += size;
        }
        extremes.add(column.range(range.begin, range.end));
    }
    result.count = static_cast<std::size_t>(moments.count);
    if (result.count == 0)
        return result;
    result.min = extremes.min;
    result.max = extremes.max;
    result.mean = moments.mean;
    result.rms = std::hypot(moments.mean, std::sqrt(moments.deviations / moments.count));
    if (result.count > 1)
        result.sigma = std::sqrt(moments.deviations / (moments.count - 1.0));
    for (const RowRange& range : rows) {
        Row first = range.begin, last = range.end;
        while (first < range.end && std::isnan(values[first]))
            ++first;
        while (last > range.begin && std::isnan(values[last - 1]))
            --last;
        if (first >= last)
            continue;
        if (std::isnan(result.first))
            result.first = values[first];
        result.last = values[last - 1];
    }
    return result;
}

} // namespace hexapose
