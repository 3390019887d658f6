// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/min_max_pyramid.h"

#include <algorithm>

namespace hexapose {

namespace {

constexpr std::size_t kLeaf = MinMaxPyramid::kLeafRows;

/// Rows of a run of a level.
constexpr std::size_t rowsOf(std::size_t level) {
    std::size_t rows = kLeaf;
    for (std::size_t i = 0; i < level; ++i)
        rows *= MinMaxPyramid::kFactor;
    return rows;
}

static_assert(rowsOf(MinMaxPyramid::kLevels - 1) == kChunkRows);

MinMax extremesOf(const double* values, std::size_t count) {
    MinMax extremes;
    for (std::size_t i = 0; i < count; ++i)
        extremes.add(values[i]);
    return extremes;
}

} // namespace

void MinMaxPyramid::grow(const Chunked<double>& values, Row rows) {
    for (; m_rows + kLeaf <= rows; m_rows += kLeaf) {
        const std::size_t chunk = m_rows / kChunkRows, within = m_rows % kChunkRows;
        if (within == 0) {
            m_chunks.push_back(std::make_shared<ChunkExtremes>());
            for (std::size_t level = 0; level < kLevels; ++level) // never moved: a copy reads meanwhile
                m_chunks.back()->levels[level].resize(kChunkRows / rowsOf(level));
        }
        auto& levels = m_chunks[chunk]->levels;
        levels[0][within / kLeaf] = extremesOf(values.chunk(chunk) + within, kLeaf);
        for (std::size_t level = 1; level < kLevels && (within + kLeaf) % rowsOf(level) == 0; ++level) {
            const std::size_t run = within / rowsOf(level);
            MinMax whole;
            for (std::size_t i = run * kFactor; i < (run + 1) * kFactor; ++i)
                whole.add(levels[level - 1][i]);
            levels[level][run] = whole;
        }
    }
}

MinMax MinMaxPyramid::range(const Chunked<double>& values, Row begin, Row end) const {
    MinMax extremes;
    while (begin < end) {
        const std::size_t chunk = begin / kChunkRows, within = begin % kChunkRows;
        // The largest run that begins here, ends in the range, and is complete.
        std::size_t level = kLevels;
        const Row known = std::min(end, m_rows);
        while (level > 0 && (within % rowsOf(level - 1) != 0 || begin + rowsOf(level - 1) > known))
            --level;
        if (level > 0) {
            extremes.add(m_chunks[chunk]->levels[level - 1][within / rowsOf(level - 1)]);
            begin += rowsOf(level - 1);
        } else {
            const std::size_t toLeaf = kLeaf - within % kLeaf;
            const std::size_t count = std::min(toLeaf, end - begin);
            extremes.add(extremesOf(values.chunk(chunk) + within, count));
            begin += count;
        }
    }
    return extremes;
}

} // namespace hexapose
