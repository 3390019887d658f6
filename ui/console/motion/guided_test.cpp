// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/guided_test.h"

#include "core/base/units.h"

#include <utility>

namespace hexapose {

namespace {

constexpr int kMostHalvings = 12;
// Longer than the second over which the lengths are averaged: the sample ends it, not the time.
constexpr std::chrono::seconds kStandsFor{3600};

Pose publishedPose() {
    return {{metresFromMm(12.0), metresFromMm(-4.0), metresFromMm(40.0)}, {0.0, 0.0, radiansFromDeg(5.0)}};
}

} // namespace

SharedPlan guidedPlan(const MotionPlanner& planner, const PlanStart& start, MotionMode mode,
                      const PlanBudget& budget) {
    const PoseVector published = publishedPose().toVector();
    double part = 1.0;
    for (int i = 0; i < kMostHalvings; ++i, part *= 0.5) {
        const Pose pose = Pose::fromVector(part * published);
        PlannedMotion plan = planner.plan(start, StraightMove{pose, mode}, budget);
        if (plan.check.ok()) {
            return std::make_shared<const PlannedMotion>(std::move(plan));
        }
    }
    return nullptr;
}

GuidedTest::GuidedTest(SharedModel model, std::shared_ptr<const ForwardSolver> solver, const Pose& target,
                       MotionId id)
    : m_model(std::move(model)), m_solver(std::move(solver)), m_target(target),
      m_run({target}, kStandsFor, id) {}

std::optional<Pose> GuidedTest::add(const Snapshot& snapshot) {
    if (m_step == Step::Done || m_step == Step::Failed) {
        return std::nullopt;
    }
    const auto due = m_run.add(snapshot);
    const auto sample = m_sampler.add(snapshot);
    if (m_run.phase() == PoseSequence::Phase::Failed) {
        m_step = Step::Failed;
    } else if (sample && m_step == Step::Average) {
        m_step = Step::Solve;
        const ErrorReport report = makeErrorReport(m_model->geometry(), *m_solver, {*sample});
        m_result = report.rows.front();
        m_step = Step::Done;
    } else if (m_run.phase() == PoseSequence::Phase::Dwelling) {
        m_step = Step::Average;
    } else if (snapshot.state == RunState::Settling) {
        m_step = Step::Settle;
    }
    return due;
}

} // namespace hexapose
