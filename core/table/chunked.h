// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace hexapose {

using Row = std::size_t; ///< 0 is the first row of values

/// Rows of one chunk: 2 MiB of doubles, one huge page.
inline constexpr std::size_t kChunkRows = std::size_t{1} << 18;

/// Memory for `bytes`, zeroed by the system on first use, in huge pages where `huge`. Throws std::bad_alloc.
std::shared_ptr<void> allocateChunk(std::size_t bytes, bool huge);

/// A sequence that only grows, in chunks that never move: a copy shares them, so that one thread reads the
/// rows it knows of while another appends further ones.
template <typename T>
class Chunked {
public:
    T operator[](Row row) const { return m_chunks[row / kChunkRows].get()[row % kChunkRows]; }
    /// The rows of a chunk, side by side.
    const T* chunk(std::size_t index) const { return m_chunks[index].get(); }
    std::size_t chunkCount() const { return m_chunks.size(); }

    /// For who appends.
    T* writable(std::size_t index) { return m_chunks[index].get(); }
    /// Makes room for so many rows in all.
    void reserve(Row rows, bool huge) {
        while (m_chunks.size() * kChunkRows < rows)
            m_chunks.push_back(std::static_pointer_cast<T>(allocateChunk(kChunkRows * sizeof(T), huge)));
    }

private:
    std::vector<std::shared_ptr<T>> m_chunks;
};

} // namespace hexapose
