// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/step_equations.h"

#include <Eigen/Geometry>

namespace hexapose {

namespace {

void add(StepRow& row, std::size_t point, const Eigen::Vector3d& gradient) {
    row.terms[row.count++] = {point, gradient};
}

/// |arm| stays: half the change of its square.
double halfSquareMisfit(const Eigen::Vector3d& arm, const Eigen::Vector3d& homeArm) {
    return 0.5 * (arm.squaredNorm() - homeArm.squaredNorm());
}

/// Velocity and acceleration of slider or crank.
struct HandMotion {
    Eigen::Vector3d velocity, acceleration;
};

HandMotion handMotion(const Actuator& actuator, const DriveState& drive) {
    if (actuator.kind == ActuatorKind::Slider)
        return {drive.rate * actuator.axis_B, drive.acceleration * actuator.axis_B};
    const Eigen::Vector3d arm = handPosition(actuator, drive.value) - actuator.centre_B;
    const Eigen::Vector3d tangent = actuator.axis_B.cross(arm);
    return {drive.rate * tangent,
            drive.acceleration * tangent + drive.rate * drive.rate * actuator.axis_B.cross(tangent)};
}

} // namespace

std::size_t rowCount(const Constraint& constraint) {
    const bool isVector =
        constraint.kind == ConstraintKind::Translation || constraint.kind == ConstraintKind::Circle;
    return isVector ? 3 : 1;
}

Eigen::Vector3d handPosition(const Actuator& actuator, double value) {
    if (actuator.kind == ActuatorKind::Slider)
        return actuator.hand_B + value * actuator.axis_B;
    return actuator.centre_B +
           Eigen::AngleAxisd(value, actuator.axis_B) * (actuator.hand_B - actuator.centre_B);
}

StepRow stepRow(const Mechanism& mechanism, const Actuator& actuator, PointVectors points, double from,
                double to) {
    StepRow row;
    const Eigen::Vector3d& node = points[actuator.node];
    if (actuator.kind == ActuatorKind::Leg) {
        const Eigen::Vector3d arm = node - points[actuator.base];
        const double length = arm.norm();
        add(row, actuator.node, arm / length);
        add(row, actuator.base, -arm / length);
        row.misfit = length - from;
        row.drive = to - from;
        return row;
    }
    const Eigen::Vector3d hand = handPosition(actuator, from);
    const Eigen::Vector3d arm = node - hand;
    add(row, actuator.node, arm);
    row.misfit = halfSquareMisfit(arm, mechanism.points[actuator.node].home_B - actuator.hand_B);
    row.drive = arm.dot(handPosition(actuator, to) - hand);
    return row;
}

StepRow stepRow(const Mechanism& mechanism, const Constraint& constraint, PointVectors points,
                std::size_t index) {
    StepRow row;
    const auto at = [&](std::size_t i) -> const Eigen::Vector3d& { return points[constraint.points[i]]; };
    const auto home = [&](std::size_t i) -> const Eigen::Vector3d& {
        return mechanism.points[constraint.points[i]].home_B;
    };
    const auto put = [&](std::size_t i, const Eigen::Vector3d& gradient) {
        add(row, constraint.points[i], gradient);
    };
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(index));
    switch (constraint.kind) {
    case ConstraintKind::Distance: {
        const Eigen::Vector3d arm = at(0) - at(1);
        put(0, arm);
        put(1, -arm);
        row.misfit = halfSquareMisfit(arm, home(0) - home(1));
        break;
    }
    case ConstraintKind::Translation:
        put(0, unit);
        put(1, -unit);
        row.misfit = unit.dot((at(0) - at(1)) - (home(0) - home(1)));
        break;
    case ConstraintKind::Projection: {
        const Eigen::Vector3d first = at(0) - at(2), second = at(1) - at(2);
        put(0, second);
        put(1, first);
        put(2, -(first + second));
        row.misfit = first.dot(second) - (home(0) - home(2)).dot(home(1) - home(2));
        break;
    }
    case ConstraintKind::Circle:
        for (std::size_t i = 0; i < 3; ++i)
            put(i, unit);
        put(3, -3.0 * unit);
        row.misfit = unit.dot(at(0) + at(1) + at(2) - 3.0 * at(3));
        break;
    case ConstraintKind::Plane:
        put(0, constraint.normal_B);
        row.misfit = constraint.normal_B.dot(at(0) - home(0));
        break;
    }
    return row;
}

double rateOf(const Actuator& actuator, PointVectors points, const DriveState& drive) {
    if (actuator.kind == ActuatorKind::Leg)
        return drive.rate;
    return (points[actuator.node] - handPosition(actuator, drive.value))
        .dot(handMotion(actuator, drive).velocity);
}

double accelerationOf(const Actuator& actuator, PointVectors points, PointVectors velocities,
                      const DriveState& drive) {
    if (actuator.kind == ActuatorKind::Leg) {
        const double length = (points[actuator.node] - points[actuator.base]).norm();
        const Eigen::Vector3d velocity = velocities[actuator.node] - velocities[actuator.base];
        return drive.acceleration - (velocity.squaredNorm() - drive.rate * drive.rate) / length;
    }
    const HandMotion hand = handMotion(actuator, drive);
    const Eigen::Vector3d arm = points[actuator.node] - handPosition(actuator, drive.value);
    return arm.dot(hand.acceleration) - (velocities[actuator.node] - hand.velocity).squaredNorm();
}

double accelerationOf(const Constraint& constraint, PointVectors velocities) {
    const auto of = [&](std::size_t i) -> const Eigen::Vector3d& { return velocities[constraint.points[i]]; };
    if (constraint.kind == ConstraintKind::Distance)
        return -(of(0) - of(1)).squaredNorm();
    if (constraint.kind == ConstraintKind::Projection)
        return -2.0 * (of(0) - of(2)).dot(of(1) - of(2));
    return 0.0;
}

} // namespace hexapose
