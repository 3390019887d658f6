// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/table/chunked.h"

#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace hexapose {

/// Smallest and largest of some values; NaN in both where there is none.
struct MinMax {
    double min = std::numeric_limits<double>::quiet_NaN();
    double max = std::numeric_limits<double>::quiet_NaN();

    bool isEmpty() const { return min != min; }
    /// A NaN is passed over.
    void add(double value) {
        if (!(value >= min))
            min = value == value ? value : min;
        if (!(value <= max))
            max = value == value ? value : max;
    }
    void add(const MinMax& other) {
        add(other.min);
        add(other.max);
    }
    bool operator==(const MinMax&) const = default;
};

/// Extremes of runs of 64 rows, of 8 such runs, and so on to a chunk, so that those of any range cost some
/// dozen steps. Grows with its column; a copy shares what is complete.
class MinMaxPyramid {
public:
    static constexpr std::size_t kLeafRows = 64;
    static constexpr std::size_t kFactor = 8;
    static constexpr std::size_t kLevels = 5; ///< 64, 512, 4096, 32768 rows; and a chunk

    /// Takes up all that is complete of the first `rows` rows.
    void grow(const Chunked<double>& values, Row rows);
    /// Of the rows [begin, end), those that grow() did not take up yet included.
    MinMax range(const Chunked<double>& values, Row begin, Row end) const;

private:
    struct ChunkExtremes {
        std::array<std::vector<MinMax>, kLevels> levels;
    };
    std::vector<std::shared_ptr<ChunkExtremes>> m_chunks;
    Row m_rows = 0; ///< a whole number of leaves
};

} // namespace hexapose
