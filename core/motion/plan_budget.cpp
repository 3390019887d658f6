// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/plan_budget.h"

#include <ctime>

namespace hexapose {

namespace {

constexpr int kAskedPerReading = 16; ///< a reading is a system call

} // namespace

std::chrono::nanoseconds threadProcessorTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

PlanTimer::PlanTimer(const PlanBudget& budget) : m_budget(budget), m_end(budget.now() + budget.time) {}

bool PlanTimer::expired() {
    if (!m_expired && ++m_asked % kAskedPerReading == 0)
        m_expired = m_budget.now() > m_end || (m_budget.isCancelled && m_budget.isCancelled());
    return m_expired;
}

} // namespace hexapose
