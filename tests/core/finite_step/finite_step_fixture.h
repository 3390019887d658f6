// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/units.h"
#include "core/finite_step/leg_path.h"
#include "core/finite_step/mechanism_file.h"
#include "core/finite_step/pose_errors.h"
#include "core/finite_step/step_system.h"
#include "core/kinematics/inverse_kinematics.h"
#include "tests/core/kinematics/test_machines.h"

#include <cmath>
#include <string>
#include <vector>

/// What the tests of finite-step integration share.
namespace hexapose::testing {

/// The laboratory platform with its origin in the middle of the platform joints, as the second paper puts it.
inline PlatformGeometry laboratoryAtJoints() {
    PlatformGeometry machine = laboratory();
    const Eigen::Vector3d lift(0.0, 0.0, metresFromMm(52.5));
    machine.p_OP_home_B += lift;
    for (Leg& leg : machine.legs)
        leg.p_PB_P -= lift;
    return machine;
}

inline Pose poseMmDeg(double x, double y, double z, double alpha, double beta, double gamma) {
    return {Eigen::Vector3d(x, y, z).unaryExpr(&metresFromMm),
            {radiansFromDeg(alpha), radiansFromDeg(beta), radiansFromDeg(gamma)}};
}

inline const Pose kTarget1 = poseMmDeg(12, -4, 40, 0, 0, 5);
inline const Pose kTarget2 = poseMmDeg(30, -20, 35, 20, -15, 25);

inline BodyMotion bodyAt(const PlatformGeometry& machine, const Pose& pose) {
    BodyMotion body;
    body.R_BP = rotationMatrix(pose.angles);
    body.p_OP_B = machine.p_OP_home_B + pose.offset;
    return body;
}

/// Euclidean position error and angle of the rotation error.
struct PathError {
    double mm;
    double deg;
};
inline PathError errorOf(const PlatformGeometry& machine, const Pose& found, const Pose& truth) {
    const PoseErrors errors = poseErrors(bodyAt(machine, found), bodyAt(machine, truth));
    return {mmFromMetres(errors.position.norm()), degFromRadians(errors.turn)};
}

inline PathError straightError(const PlatformGeometry& machine, const Pose& target, int steps,
                               StepForm form) {
    const LegPath path(machine);
    const PathResult result = path.followStraight(Pose{}, legLengths(machine, target), steps, form);
    return errorOf(machine, result.pose, target);
}

/// Three joints as nodes, the others carried, three distances: the smallest system of a 6-UPS.
inline Mechanism nineUnknowns(const PlatformGeometry& machine) {
    Mechanism mechanism = mechanismOf(machine);
    mechanism.points.pop_back();
    for (MechanismPoint& point : mechanism.points)
        if (point.kind != PointKind::Fixed)
            point.carriers.resize(3);
    std::erase_if(mechanism.constraints,
                  [&](const Constraint& distance) { return distance.points[1] >= mechanism.points.size(); });
    return mechanism;
}

inline std::string mechanismFile(const std::string& name) {
    return std::string(HEXAPOSE_SOURCE_DIR) + "/resources/mechanisms/" + name + ".toml";
}
inline StepSystem shippedSystem(const std::string& name) {
    const std::string file = mechanismFile(name);
    return StepSystem(loadMechanism(file), file);
}

} // namespace hexapose::testing
