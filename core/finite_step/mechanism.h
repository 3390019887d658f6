// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/rigid_fit.h"
#include "core/geometry/platform_geometry.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hexapose {

/// What a mechanism is made of, from which its step equations are assembled (Front. Mech. Eng. 2025, 20(1):7,
/// sections 2 and 3). Base frame throughout, m and rad.

/// Fixed: part of the base. Node: a mark point, three of the unknowns. Carried: moves with three or four
/// nodes as part of one body with them, and adds no unknown.
enum class PointKind : std::uint8_t { Fixed, Node, Carried };
struct MechanismPoint {
    std::string name;
    Eigen::Vector3d home_B = Eigen::Vector3d::Zero();
    PointKind kind = PointKind::Fixed;
    std::vector<std::size_t> carriers; ///< of a carried point: three or four nodes, by their place here
};

/// Leg: a length between two points (UPS, RPS, UPU, RPU; Eq. 3). Slider and crank: a rod to a point that the
/// actuator moves (PUS, RUS; Eq. 8).
enum class ActuatorKind : std::uint8_t { Leg, Slider, Crank };
struct Actuator {
    std::string name;
    ActuatorKind kind = ActuatorKind::Leg;
    std::size_t node = 0;                             ///< the point it moves
    std::size_t base = 0;                             ///< of a leg: its other end
    Eigen::Vector3d hand_B = Eigen::Vector3d::Zero(); ///< of slider and crank: where the rod is held, at home
    Eigen::Vector3d centre_B = Eigen::Vector3d::Zero(); ///< of a crank: a point of its axis
    Eigen::Vector3d axis_B = Eigen::Vector3d::UnitZ();  ///< of slider and crank: unit vector
    /// The reference drive of the motion tracking: amplitude sin(rate t) about home, m or rad, rad/s.
    double referenceAmplitude = 0.0;
    double referenceRate = 0.0;
};

/// Distance: two points keep theirs (Eq. 6, 7). Translation: two points move alike (Fig. 6a). Projection: the
/// scalar product of two arms from a centre stays (Eq. 11). Circle: three points and their centre (Eq. 12).
/// Plane: a point stays in one (Eq. 13).
enum class ConstraintKind : std::uint8_t { Distance, Translation, Projection, Circle, Plane };
struct Constraint {
    ConstraintKind kind = ConstraintKind::Distance;
    /// Distance and translation: two points. Projection: two, then the centre. Circle: three, then the
    /// centre. Plane: one.
    std::vector<std::size_t> points;
    Eigen::Vector3d normal_B = Eigen::Vector3d::UnitZ(); ///< of a plane: unit vector
};

struct Mechanism {
    std::string name;
    BodyFit output; ///< the point whose motion is asked for, and how its body can move
    std::vector<MechanismPoint> points;
    std::vector<Actuator> actuators;
    std::vector<Constraint> constraints;

    /// "actuator l1", "distance B1-B3", ...: what messages call an equation.
    std::string nameOf(const Actuator& actuator) const { return "actuator " + actuator.name; }
    std::string nameOf(const Constraint& constraint) const;
};

/// What stands at the actuators at home: the length of a leg; 0 for slider and crank, which count from there.
double homeValue(const Mechanism& mechanism, const Actuator& actuator);

/// The marks of a six-legged platform: three joints, by the index of their legs, that span a large triangle
/// (legs 1, 3 and 5 unless another triple spans more than twice as much), and a point off their plane. That
/// is the base frame's origin at home, as in the paper, or, where that is too near to the plane, a point
/// below the joints. Throws InputError when no three joints span a triangle.
struct HexapodMarks {
    std::array<std::size_t, 3> legs;
    Eigen::Vector3d fourth_B; ///< at home
};
HexapodMarks hexapodMarks(const PlatformGeometry& geometry);

/// The 12x12 system of a six-legged platform: the marks as nodes, the other joints carried by them, six
/// distances. Throws as hexapodMarks().
Mechanism mechanismOf(const PlatformGeometry& geometry);

} // namespace hexapose
