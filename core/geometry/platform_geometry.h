// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hexapose {

/// One leg: its two joints and its stroke.
struct Leg {
    Eigen::Vector3d p_OA_B = Eigen::Vector3d::Zero(); ///< base joint A_i, from O, base frame, m
    Eigen::Vector3d p_PB_P = Eigen::Vector3d::Zero(); ///< platform joint B_i, from P, platform frame, m
    double minLength = 0.0;                           ///< stroke: shortest, m
    double maxLength = 0.0;                           ///< stroke: longest, m
};

/// A 6-UPS platform. Frames: B is the base frame with origin O, P the platform frame with origin P; at pose
/// zero their axes are parallel. Its functions expect a geometry that validate() accepts, and throw nothing
/// for another: its numbers are then not to be relied on.
struct PlatformGeometry {
    std::string name;
    Eigen::Vector3d p_OP_home_B = Eigen::Vector3d::Zero(); ///< P at pose zero, from O, base frame, m
    std::array<Leg, kLegCount> legs;

    /// Leg lengths at pose zero (Eq. 3), m.
    LegLengths homeLengths() const;
    /// The machine's own size, m: the mean leg length at home. Tolerances scale with it.
    double size() const;
    /// Lever arm of the rotation, m: root mean square of |p_PB_P|; makes Jacobian columns comparable.
    double jointRadius() const;
    /// FNV-1a over home position and joints, as 16 hex digits: what a regression model depends on. Strokes
    /// and name are left out, because the kinematics do not depend on them.
    std::string fingerprint() const;
};

/// One thing wrong with a geometry, and where in a platform file it stands.
struct GeometryFault {
    int leg;          ///< 1 to 6; 0: not a leg
    std::string key;  ///< "min_mm", ... as in the platform file
    std::string text; ///< the sentence of validate()
};
/// What validate() reports, each with its place. Throws nothing.
std::vector<GeometryFault> findFaults(const PlatformGeometry& geometry);

/// Everything wrong with a geometry, one sentence each with leg, value and bound, in mm ("leg 3: min_mm 350
/// is not below max_mm 250"). Empty when the geometry can be used. Checks: numbers finite, 0 < min < max,
/// home inside the strokes, no two legs that share both joints (sharing one is legal, as in a 3-3 octahedral
/// platform), base joints and platform joints neither all coincident nor all on one line, home lengths
/// positive.
std::vector<std::string> validate(const PlatformGeometry& geometry);

} // namespace hexapose
