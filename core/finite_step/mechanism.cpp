// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/mechanism.h"

#include "core/base/input_error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr double kPreferredPart = 0.5; ///< of the largest triangle, from which legs 1, 3, 5 are taken
constexpr double kLeastHeight = 0.3;   ///< of the fourth mark over the plane of the others, over their width

double triangle(const PlatformGeometry& geometry, const std::array<std::size_t, 3>& legs) {
    const Eigen::Vector3d first = geometry.legs[legs[0]].p_PB_P;
    return (geometry.legs[legs[1]].p_PB_P - first).cross(geometry.legs[legs[2]].p_PB_P - first).norm();
}

std::string numbered(const char* letter, std::size_t index) {
    std::string name(letter);
    name += std::to_string(index + 1);
    return name;
}

} // namespace

std::string Mechanism::nameOf(const Constraint& constraint) const {
    const auto joined = [&](std::size_t count) {
        std::string text;
        for (std::size_t i = 0; i < count; ++i)
            text += (i == 0 ? "" : "-") + points[constraint.points[i]].name;
        return text;
    };
    switch (constraint.kind) {
    case ConstraintKind::Distance:
        return "distance " + joined(2);
    case ConstraintKind::Translation:
        return "translation " + joined(2);
    case ConstraintKind::Projection:
        return "projection " + joined(2) + " about " + points[constraint.points[2]].name;
    case ConstraintKind::Circle:
        return "circle " + joined(3) + " about " + points[constraint.points[3]].name;
    case ConstraintKind::Plane:
        break;
    }
    return "plane " + joined(1);
}

double homeValue(const Mechanism& mechanism, const Actuator& actuator) {
    if (actuator.kind != ActuatorKind::Leg)
        return 0.0;
    return (mechanism.points[actuator.node].home_B - mechanism.points[actuator.base].home_B).norm();
}

HexapodMarks hexapodMarks(const PlatformGeometry& geometry) {
    HexapodMarks marks{{0, 2, 4}, Eigen::Vector3d::Zero()};
    double largest = triangle(geometry, marks.legs) / kPreferredPart;
    for (std::size_t i = 0; i < kLegCount; ++i)
        for (std::size_t j = i + 1; j < kLegCount; ++j)
            for (std::size_t k = j + 1; k < kLegCount; ++k)
                if (const double size = triangle(geometry, {i, j, k}); size > largest) {
                    largest = size;
                    marks.legs = {i, j, k};
                }
    const auto joint = [&](std::size_t k) {
        return Eigen::Vector3d(geometry.p_OP_home_B + geometry.legs[marks.legs[k]].p_PB_P);
    };
    const Eigen::Vector3d middle = (joint(0) + joint(1) + joint(2)) / 3.0;
    const Eigen::Vector3d normal = (joint(1) - joint(0)).cross(joint(2) - joint(0));
    if (!(normal.norm() > 0.0))
        throw InputError(geometry.name, "no three platform joints span a triangle");
    const double width = (joint(0) - middle).norm();
    if (!(std::abs(normal.normalized().dot(middle)) > kLeastHeight * width))
        marks.fourth_B = middle - width * normal.normalized();
    return marks;
}

Mechanism mechanismOf(const PlatformGeometry& geometry) {
    const HexapodMarks marks = hexapodMarks(geometry);
    Mechanism mechanism;
    mechanism.name = geometry.name;
    mechanism.output.p_OP_home_B = geometry.p_OP_home_B;
    for (std::size_t i = 0; i < kLegCount; ++i)
        mechanism.points.push_back({numbered("A", i), geometry.legs[i].p_OA_B, PointKind::Fixed, {}});
    std::vector<std::size_t> nodes{kLegCount + marks.legs[0], kLegCount + marks.legs[1],
                                   kLegCount + marks.legs[2], 2 * kLegCount};
    for (std::size_t i = 0; i < kLegCount; ++i) {
        const bool isMark = std::find(marks.legs.begin(), marks.legs.end(), i) != marks.legs.end();
        mechanism.points.push_back({numbered("B", i), geometry.p_OP_home_B + geometry.legs[i].p_PB_P,
                                    isMark ? PointKind::Node : PointKind::Carried, nodes});
        Actuator leg;
        leg.name = numbered("l", i);
        leg.base = i;
        leg.node = kLegCount + i;
        mechanism.actuators.push_back(leg);
    }
    mechanism.points.push_back({"O", marks.fourth_B, PointKind::Node, {}});
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = i + 1; j < nodes.size(); ++j)
            mechanism.constraints.push_back(
                {ConstraintKind::Distance, {nodes[i], nodes[j]}, Eigen::Vector3d::UnitZ()});
    return mechanism;
}

} // namespace hexapose
