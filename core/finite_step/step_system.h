// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/mechanism.h"
#include "core/finite_step/step_equations.h"

#include <Eigen/Core>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace hexapose {

/// Memory of one run, made by StepSystem::workspace(): a step allocates nothing.
struct StepWorkspace {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right;
    std::vector<Eigen::Vector3d> points, velocities;
};

/// The right-hand side of a step. Drive: what the actuators' step asks for (the paper's form). Closed: that,
/// and what is missing of every constraint. Correction: only what is missing, at the values gone to.
enum class StepSide : std::uint8_t { Drive, Closed, Correction };

/// The square system of step equations of a mechanism (Front. Mech. Eng. 2025, 20(1):7, Eq. 14 and 15): the
/// step matrix over the shifts of all nodes, rows divided by their natural length. Node vectors hold x y z
/// of each node in the order of the mechanism's points, base frame, m. Immutable.
class StepSystem {
public:
    /// Throws InputError, "source: cause", when the set is not square or not of full rank at home.
    StepSystem(Mechanism mechanism, const std::string& source);

    const Mechanism& mechanism() const noexcept { return m_mechanism; }
    Eigen::Index unknowns() const noexcept { return m_homeNodes.size(); }
    const Eigen::VectorXd& homeNodes() const noexcept { return m_homeNodes; }
    const Eigen::VectorXd& homeDrive() const noexcept { return m_homeDrive; }
    /// All points that move, one a column: at home, and where the nodes are given.
    const Eigen::Matrix3Xd& homeBody() const noexcept { return m_homeBody; }
    Eigen::Matrix3Xd bodyOf(const Eigen::VectorXd& nodes) const;
    /// Largest over smallest singular value of the step matrix at home.
    double homeCondition() const noexcept { return m_homeCondition; }
    StepWorkspace workspace() const;

    /// Where the nodes go when the actuators go from `from` to `to`, into `shift`. Returns q, the step
    /// matrix's determinant over that at home, and 0 or NaN where there is no solution.
    double step(const Eigen::VectorXd& nodes, const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                StepSide side, StepWorkspace& memory, Eigen::VectorXd& shift) const noexcept;
    /// Velocities and accelerations of the nodes, by the first and second derivative of every equation.
    /// Returns q.
    double motion(const Eigen::VectorXd& nodes, std::span<const DriveState> drive, StepWorkspace& memory,
                  Eigen::VectorXd& velocity, Eigen::VectorXd& acceleration) const noexcept;
    /// q at these nodes; the step matrix is left in memory.matrix, taken apart.
    double determinantRatio(const Eigen::VectorXd& nodes, const Eigen::VectorXd& drive,
                            StepWorkspace& memory) const noexcept;
    /// Smallest singular value of the step matrix there; allocates.
    double smallestSingularValue(const Eigen::VectorXd& nodes, const Eigen::VectorXd& drive) const;
    /// Norm of what is missing of the equations, each over its natural length, m.
    double residual(const Eigen::VectorXd& nodes, const Eigen::VectorXd& drive,
                    StepWorkspace& memory) const noexcept;

private:
    /// A carried point: B = M1 + u a + v b + w c, with a = M2 - M1, b = M3 - M1, and c = M4 - M1, or a x b
    /// where there are three carriers.
    struct Carriage {
        std::array<Eigen::Index, 4> nodes{-1, -1, -1, -1}; ///< first index in the node vector, -1: none
        double u = 0.0, v = 0.0, w = 0.0;
        bool hasFour() const noexcept { return nodes[3] >= 0; }
    };
    struct Frame;
    static Frame frameOf(const Eigen::VectorXd& nodes, const Carriage& carriage) noexcept;
    void placePoints(const Eigen::VectorXd& nodes, std::vector<Eigen::Vector3d>& points) const noexcept;
    void movePoints(const Eigen::VectorXd& nodes, const Eigen::VectorXd& velocity,
                    std::vector<Eigen::Vector3d>& velocities) const noexcept;
    Eigen::Vector3d bend(std::size_t point, const Eigen::VectorXd& velocity) const noexcept;
    double addRow(Eigen::Index index, const StepRow& row, const Eigen::VectorXd& nodes,
                  Eigen::MatrixXd& matrix) const noexcept;
    void assemble(const Eigen::VectorXd& nodes, const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                  StepSide side, StepWorkspace& memory) const noexcept;
    void prepareCarriage(std::size_t point, const std::string& source);
    std::vector<std::string> rowNames() const;
    std::vector<std::string> unknownNames() const;

    Mechanism m_mechanism;
    std::vector<Eigen::Index> m_first; ///< of each point: first index in the node vector, -1 for none
    std::vector<Carriage> m_carriages; ///< of each point
    Eigen::Index m_rows = 0;
    Eigen::VectorXd m_homeNodes, m_homeDrive;
    Eigen::Matrix3Xd m_homeBody;
    double m_homeDeterminant = 1.0;
    double m_homeCondition = 0.0;
};

} // namespace hexapose
