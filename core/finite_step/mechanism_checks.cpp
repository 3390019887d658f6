// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/mechanism_checks.h"

#include "core/geometry/singular_values.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hexapose {

namespace {

/// Points nearer than this, over the largest coordinate, count as one; likewise for lines.
constexpr double kCoincident = 1e-9;

double extent(const Mechanism& mechanism) {
    double most = 0.0;
    for (const MechanismPoint& point : mechanism.points)
        most = std::max(most, point.home_B.cwiseAbs().maxCoeff());
    return most;
}

bool coincide(const Mechanism& mechanism, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return !((a - b).norm() > kCoincident * extent(mechanism));
}

} // namespace

std::string carriageFault(const Mechanism& mechanism, const MechanismPoint& point) {
    for (const std::size_t carrier : point.carriers)
        if (mechanism.points[carrier].kind != PointKind::Node)
            return "is carried by \"" + mechanism.points[carrier].name +
                   "\", which is fixed or carried itself";
    const auto at = [&](std::size_t k) { return mechanism.points[point.carriers[k]].home_B; };
    const Eigen::Vector3d a = at(1) - at(0), b = at(2) - at(0);
    if (!(a.cross(b).norm() > kCoincident * (a.squaredNorm() + b.squaredNorm())))
        return "is carried by three nodes on one line";
    if (point.carriers.size() == 3)
        return {};
    const Eigen::Vector3d c = at(3) - at(0);
    if (!(std::abs(a.cross(b).dot(c)) > kCoincident * a.norm() * b.norm() * c.norm()))
        return "is carried by four nodes in one plane";
    return {};
}

std::string actuatorFault(const Mechanism& mechanism, const Actuator& actuator) {
    const bool isLeg = actuator.kind == ActuatorKind::Leg;
    const Eigen::Vector3d other = isLeg ? mechanism.points[actuator.base].home_B : actuator.hand_B;
    if (coincide(mechanism, mechanism.points[actuator.node].home_B, other))
        return "its two ends are one point at home";
    const Eigen::Vector3d arm = (actuator.hand_B - actuator.centre_B).cross(actuator.axis_B);
    if (actuator.kind == ActuatorKind::Crank && coincide(mechanism, arm, Eigen::Vector3d::Zero()))
        return "the end of the crank lies on its axis";
    return {};
}

std::string constraintFault(const Mechanism& mechanism, const Constraint& constraint) {
    const auto at = [&](std::size_t k) -> const Eigen::Vector3d& {
        return mechanism.points[constraint.points[k]].home_B;
    };
    if (constraint.kind == ConstraintKind::Distance && coincide(mechanism, at(0), at(1)))
        return "the two points are one at home";
    if (constraint.kind == ConstraintKind::Circle && !coincide(mechanism, at(0) + at(1) + at(2), 3.0 * at(3)))
        return "the centre is not the mean of the three points at home";
    return {};
}

std::string outputFault(const Mechanism& mechanism) {
    if (!mechanism.output.turns)
        return {};
    std::vector<Eigen::Vector3d> body;
    for (const MechanismPoint& point : mechanism.points)
        if (point.kind == PointKind::Node)
            body.push_back(point.home_B);
    if (mechanism.output.pivot_B)
        body.push_back(*mechanism.output.pivot_B);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : body)
        sum += point;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& point : body) {
        const Eigen::Vector3d arm = point - sum / static_cast<double>(body.size());
        spread += arm * arm.transpose();
    }
    const Eigen::Vector3d extents = singularValues(Eigen::MatrixXd(spread));
    if (body.size() >= 3 && extents[1] > kCoincident * extents[0])
        return {};
    return "how it is turned shows only in three nodes that are not on one line; without them write turns = "
           "false";
}

} // namespace hexapose
