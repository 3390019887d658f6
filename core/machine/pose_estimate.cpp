// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/machine/pose_estimate.h"

#include <utility>

namespace hexapose {

PoseEstimate::PoseEstimate(SharedModel model, const ForwardSolver& solver)
    : m_model(std::move(model)), m_solver(solver) {}

void PoseEstimate::update(const LegLengths& measured) {
    using Clock = std::chrono::steady_clock;
    m_lengths = measured;
    const Clock::time_point begin = Clock::now();
    m_solution = m_solver.solve(measured, m_lastPose);
    m_solveTime = Clock::now() - begin;
    m_pose.reset();
    if (!m_solution.isUsable())
        return;
    m_pose = m_lastPose = m_solution.pose;
    m_singularity = m_model->singularity(m_solution.pose);
}

std::optional<Pose> PoseEstimate::poseOf(const LegLengths& setPoint, const std::optional<Pose>& near) const {
    const ForwardResult result = m_solver.solve(setPoint, near.value_or(m_lastPose));
    return result.isUsable() ? std::optional(result.pose) : std::nullopt;
}

} // namespace hexapose
