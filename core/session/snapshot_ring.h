// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/record/snapshot.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

namespace hexapose {

using SnapshotPtr = std::shared_ptr<const Snapshot>;

/// The cycles of the last while, kept once for all who read them. The loop publishes and waits for nobody; a
/// reader that asks too seldom misses the oldest.
class SnapshotRing {
public:
    explicit SnapshotRing(std::chrono::nanoseconds kept = std::chrono::seconds(30)) : m_keptFor(kept) {}

    void publish(SnapshotPtr snapshot);
    /// Forgets all of them, for every reader: another session begins.
    void clear();

private:
    friend class SnapshotReader;

    const std::chrono::nanoseconds m_keptFor;
    mutable std::mutex m_mutex;
    mutable std::condition_variable m_published;
    std::deque<SnapshotPtr> m_kept;
    std::uint64_t m_firstNumber = 0; ///< of the first one kept
};

/// A place in the ring. Each screen, job or bridge has its own, on its own thread.
class SnapshotReader {
public:
    SnapshotReader() = default; ///< of nothing
    /// From the oldest that is kept.
    explicit SnapshotReader(std::shared_ptr<const SnapshotRing> ring) : m_ring(std::move(ring)) {}

    /// Those published since the last call, oldest first.
    std::vector<SnapshotPtr> take();
    /// Until there is something to take; false when nothing came within this time.
    bool wait(std::chrono::milliseconds atMost) const;

private:
    std::shared_ptr<const SnapshotRing> m_ring;
    std::uint64_t m_nextNumber = 0;
};

} // namespace hexapose
