// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/planner.h"

#include "core/base/thread_priority.h"

#include <utility>

namespace hexapose {

namespace {

SharedPlan planOf(const PlatformModel& model, const PlanJob& job) {
    return std::make_shared<const PlannedMotion>(
        planMotion(model, job.bounds, job.limits, job.strokeSlack, job.start, job.request));
}

} // namespace

void ImmediatePlanner::submit(const PlanJob& job) {
    m_plan = planOf(*m_model, job);
}

SharedPlan ImmediatePlanner::take() {
    return std::exchange(m_plan, nullptr);
}

PlanningThread::PlanningThread(SharedModel model)
    : m_model(std::move(model)), m_thread([this](const std::stop_token& stop) { run(stop); }) {}

void PlanningThread::submit(const PlanJob& job) {
    {
        const std::lock_guard lock(m_mutex);
        m_job = job;
        m_plan.reset();
    }
    m_changed.notify_one();
}

SharedPlan PlanningThread::take() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_plan, nullptr);
}

void PlanningThread::run(const std::stop_token& stop) {
    resetThreadPriority(); // the loop starts it, and must not wait for it
    std::unique_lock lock(m_mutex);
    while (m_changed.wait(lock, stop, [this] { return m_job.has_value(); })) {
        const PlanJob job = *std::exchange(m_job, std::nullopt);
        lock.unlock();
        SharedPlan plan = planOf(*m_model, job);
        lock.lock();
        if (!m_job) // else a newer job has replaced this one
            m_plan = std::move(plan);
    }
}

} // namespace hexapose
