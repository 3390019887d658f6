// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/motion_planner.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace hexapose {

/// What is to be planned.
struct PlanJob {
    MotionRequest request;
    PlanStart start;
    MotionLimits limits;
    MotionBounds bounds;
    double strokeSlack = 0.0; ///< m, see planMotion()
};

/// Plans one motion at a time for the loop, which never plans itself.
class Planner {
public:
    virtual ~Planner() = default;
    /// A job that is still being worked on is forgotten.
    virtual void submit(const PlanJob& job) = 0;
    /// The plan of the last job, once; null while it is not there.
    virtual SharedPlan take() = 0;
};

/// Plans at once, on the caller's thread: for a loop in a time of its own, which waits for nobody.
class ImmediatePlanner final : public Planner {
public:
    explicit ImmediatePlanner(SharedModel model) : m_model(std::move(model)) {}
    void submit(const PlanJob& job) override;
    SharedPlan take() override;

private:
    SharedModel m_model;
    SharedPlan m_plan;
};

/// Plans on a thread of its own.
class PlanningThread final : public Planner {
public:
    explicit PlanningThread(SharedModel model);
    void submit(const PlanJob& job) override;
    SharedPlan take() override;

private:
    void run(const std::stop_token& stop);

    SharedModel m_model;
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::optional<PlanJob> m_job;
    SharedPlan m_plan;
    std::jthread m_thread; ///< last: it ends first
};

} // namespace hexapose
