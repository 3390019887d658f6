// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/drive_path.h"
#include "core/finite_step/rigid_fit.h"
#include "core/finite_step/step_form.h"
#include "core/finite_step/step_system.h"
#include "core/finite_step/stop_rule.h"

#include <Eigen/Core>

#include <vector>

namespace hexapose {

/// Finite-step integration (Front. Mech. Eng. 2025, 20(1):7, Algorithm 1) of any mechanism: follows the nodes
/// along a drive path step by step, and stops before a singular pose. A step allocates nothing.
class NodePath {
public:
    /// System and drive must outlive this. `nodes`: where the path begins, at the drive's first values.
    NodePath(const StepSystem& system, const DrivePath& drive, int steps, StepForm form,
             const Eigen::VectorXd& nodes);

    /// One step on. False at the end of the path, and where it is singular; there it stays on the last node
    /// that is on the path.
    bool advance() noexcept;
    bool isSingular() const noexcept { return m_singular; }

    int step() const noexcept { return m_step; }
    double time() const noexcept { return timeOf(m_step); }
    const Eigen::VectorXd& nodes() const noexcept { return m_nodes; }
    /// Values at this step.
    const std::vector<DriveState>& drive() const noexcept { return m_drive; }
    Eigen::VectorXd driveValues() const { return m_from; }
    /// Of the step matrix here, as far as known: from advance() on.
    double q() const noexcept { return m_q; }
    double smallestSingularValue() const { return m_system.smallestSingularValue(m_nodes, m_from); }

private:
    double timeOf(int step) const noexcept;
    void readDrive(int step, Eigen::VectorXd& values) noexcept;

    const StepSystem& m_system;
    const DrivePath& m_path;
    int m_steps;
    StepForm m_form;
    StepWorkspace m_memory;
    std::vector<DriveState> m_drive;
    Eigen::VectorXd m_nodes, m_before, m_shift, m_from, m_to, m_fromBefore;
    int m_step = 0;
    double m_q;
    StopRule m_rule;
    bool m_singular = false;
};

/// Nodes of a system as columns of points.
inline Eigen::Map<const Eigen::Matrix3Xd> asPoints(const Eigen::VectorXd& nodes) {
    return {nodes.data(), 3, nodes.size() / 3};
}

/// The output's pose, by best rigid fit of all points that move.
inline BodyMotion poseOfNodes(const StepSystem& system, const Eigen::VectorXd& nodes) {
    return motionFit(system.mechanism().output, system.homeBody(), system.bodyOf(nodes));
}

/// Newton's iteration on the constraints at these values of the actuators, from `nodes`. False when it does
/// not come to rest.
bool solveNodes(const StepSystem& system, const Eigen::VectorXd& drive, StepWorkspace& memory,
                Eigen::VectorXd& shift, Eigen::VectorXd& nodes) noexcept;

} // namespace hexapose
