// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/snapshot_ring.h"

#include <algorithm>
#include <utility>

namespace hexapose {

void SnapshotRing::publish(SnapshotPtr snapshot) {
    {
        const std::lock_guard lock(m_mutex);
        const std::chrono::nanoseconds newest = snapshot->time;
        m_kept.push_back(std::move(snapshot));
        while (newest - m_kept.front()->time > m_keptFor) {
            m_kept.pop_front();
            ++m_firstNumber;
        }
    }
    m_published.notify_all();
}

void SnapshotRing::clear() {
    const std::lock_guard lock(m_mutex);
    m_firstNumber += m_kept.size();
    m_kept.clear();
}

std::vector<SnapshotPtr> SnapshotReader::take() {
    if (!m_ring)
        return {};
    const std::lock_guard lock(m_ring->m_mutex);
    m_nextNumber = std::max(m_nextNumber, m_ring->m_firstNumber);
    const auto begin =
        m_ring->m_kept.begin() + static_cast<std::ptrdiff_t>(m_nextNumber - m_ring->m_firstNumber);
    std::vector<SnapshotPtr> taken(begin, m_ring->m_kept.end());
    m_nextNumber += taken.size();
    return taken;
}

bool SnapshotReader::wait(std::chrono::milliseconds atMost) const {
    if (!m_ring)
        return false;
    std::unique_lock lock(m_ring->m_mutex);
    return m_ring->m_published.wait_for(
        lock, atMost, [this] { return m_ring->m_firstNumber + m_ring->m_kept.size() > m_nextNumber; });
}

} // namespace hexapose
