// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/vector/parallel_lanes.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace hexapose {

namespace {

constexpr std::chrono::milliseconds kPollInterval{25};

/// Hands out lanes and counts those done.
class Lanes {
public:
    Lanes(int count, const std::function<void(int)>& work) : m_count(count), m_work(work) {}

    void workThrough() {
        std::unique_lock lock(m_mutex);
        while (m_next < m_count) {
            const int lane = m_next++;
            lock.unlock();
            m_work(lane);
            lock.lock();
            ++m_done;
        }
        m_changed.notify_all();
    }
    /// Whether all are done, after waiting a little.
    bool waitForAll() {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, kPollInterval, [this] { return m_done == m_count; });
    }

private:
    const int m_count;
    const std::function<void(int)>& m_work;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    int m_next = 0;
    int m_done = 0;
};

} // namespace

void runLanes(int lanes, unsigned threads, const std::function<void(int)>& work,
              const std::function<void()>& poll) {
    if (threads == 0)
        threads = std::max(1U, std::thread::hardware_concurrency());
    Lanes shared(lanes, work);
    std::vector<std::jthread> workers;
    try {
        for (unsigned i = 0; i < std::min(threads, static_cast<unsigned>(lanes)); ++i)
            workers.emplace_back([&shared] { shared.workThrough(); });
    } catch (const std::system_error&) {
        if (workers.empty()) // no thread to be had: do it here
            shared.workThrough();
    }
    while (!shared.waitForAll())
        poll();
    poll();
}

} // namespace hexapose
