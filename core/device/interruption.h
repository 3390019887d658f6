// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace hexapose {

/// One thread waits, any other ends the wait: the present one, or the next.
class Interruption {
public:
    void request() {
        {
            const std::lock_guard lock(m_mutex);
            m_requested = true;
        }
        m_changed.notify_one();
    }
    /// Whether there was a request; there is none afterwards.
    bool take() {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_requested, false);
    }
    /// Until a request, which is taken, or for so long.
    void wait(std::chrono::milliseconds longest) {
        std::unique_lock lock(m_mutex);
        m_changed.wait_for(lock, longest, [this] { return m_requested; });
        m_requested = false;
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_requested = false;
};

} // namespace hexapose
