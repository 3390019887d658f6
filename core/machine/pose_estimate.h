// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/kinematics/forward_solver.h"
#include "core/kinematics/platform_model.h"

#include <chrono>
#include <optional>

namespace hexapose {

/// The platform's pose from the measured lengths.
class PoseEstimate {
public:
    PoseEstimate(SharedModel model, const ForwardSolver& solver);

    /// m, of a new measurement. The solution starts at the last usable pose, at home before the first.
    void update(const LegLengths& measured);

    const std::optional<LegLengths>& lengths() const { return m_lengths; } ///< of the last measurement, m
    /// Of P from home, base frame; empty unless the last solution is usable.
    const std::optional<Pose>& pose() const { return m_pose; }
    const ForwardResult& solution() const { return m_solution; }
    std::chrono::nanoseconds solveTime() const { return m_solveTime; }
    /// At the pose; of the last usable pose where there is none.
    const SingularityMeasure& singularity() const { return m_singularity; }
    /// q: the determinant over that at home.
    double determinantRatio() const { return m_model->ratioOf(m_singularity.determinant); }
    /// The pose of set-points, m; empty without a usable solution.
    std::optional<Pose> poseOf(const LegLengths& setPoint, const std::optional<Pose>& near) const;

private:
    SharedModel m_model;
    const ForwardSolver& m_solver;
    std::optional<LegLengths> m_lengths;
    ForwardResult m_solution;
    std::chrono::nanoseconds m_solveTime{0};
    std::optional<Pose> m_pose;
    Pose m_lastPose;
    SingularityMeasure m_singularity;
};

} // namespace hexapose
