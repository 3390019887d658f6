// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/machine/control_options.h"
#include "core/report/error_report.h"
#include "core/session/pose_sequence.h"

#include <memory>
#include <optional>

namespace hexapose {

/// Plans the way to the pose of the published test, or to one like it that a machine can reach: half of it, a
/// quarter ... Null where even home cannot be reached.
SharedPlan guidedPlan(const MotionPlanner& planner, const PlanStart& start, MotionMode mode,
                      const PlanBudget& budget = {});

/// The published physical test: one pose, settled, its lengths averaged for a second, solved and
/// compared. Fed with snapshots; pure.
class GuidedTest {
public:
    enum class Step { Move, Settle, Average, Solve, Done, Failed };

    GuidedTest(SharedModel model, std::shared_ptr<const ForwardSolver> solver, const Pose& target,
               MotionId id);
    /// The target, when its Run is due.
    std::optional<Pose> add(const Snapshot& snapshot);
    Step step() const { return m_step; }
    const Pose& target() const { return m_target; }
    /// Of a test that is done.
    const std::optional<ErrorRow>& result() const { return m_result; }
    /// Whether the loop took its Run.
    bool accepted() const { return m_run.accepted() > 0; }
    const PoseSequence& run() const { return m_run; }

private:
    SharedModel m_model;
    std::shared_ptr<const ForwardSolver> m_solver;
    Pose m_target;
    PoseSequence m_run;
    SettledSampler m_sampler;
    Step m_step = Step::Move;
    std::optional<ErrorRow> m_result;
};

} // namespace hexapose
