// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/mechanism.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>

namespace hexapose {

/// Where the points of a mechanism are, or how they move: one vector a point, base frame, m or m/s.
using PointVectors = std::span<const Eigen::Vector3d>;

/// One linear equation for the shifts of points: sum of gradient . dP = right-hand side (Front. Mech. Eng.
/// 2025, 20(1):7, Eq. 3 to 13).
struct StepRow {
    struct Term {
        std::size_t point = 0;
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    };
    std::array<Term, 4> terms{};
    std::size_t count = 0;
    double misfit = 0.0; ///< by how much the constraint itself is broken; the gradient is its derivative
    double drive = 0.0;  ///< what the actuator's step asks for
};

/// How many equations a constraint stands for.
std::size_t rowCount(const Constraint& constraint);

/// Position of slider or crank at an actuator value, base frame, m.
Eigen::Vector3d handPosition(const Actuator& actuator, double value);

/// The equation of an actuator whose value goes from `from` to `to`, at the points of `from`.
StepRow stepRow(const Mechanism& mechanism, const Actuator& actuator, PointVectors points, double from,
                double to);
/// The equation `index` of a constraint.
StepRow stepRow(const Mechanism& mechanism, const Constraint& constraint, PointVectors points,
                std::size_t index);

/// Value, rate and second derivative of an actuator.
struct DriveState {
    double value = 0.0;
    double rate = 0.0;
    double acceleration = 0.0;
};
/// Right-hand side of the same equations for the velocities of the points; constraints have 0.
double rateOf(const Actuator& actuator, PointVectors points, const DriveState& drive);
/// Right-hand side for their accelerations: the second derivative of the constraint, the terms without
/// accelerations on the other side.
double accelerationOf(const Actuator& actuator, PointVectors points, PointVectors velocities,
                      const DriveState& drive);
double accelerationOf(const Constraint& constraint, PointVectors velocities);

} // namespace hexapose
