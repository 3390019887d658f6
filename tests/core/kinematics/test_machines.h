// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/units.h"
#include "core/geometry/geometry_file.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/regression/polynomial_training.h"

#include <cmath>
#include <map>
#include <ostream>
#include <random>
#include <string>
#include <utility>

/// Machines and poses that the kinematics tests share.
namespace hexapose::testing {

inline PlatformGeometry laboratory() {
    return loadPlatform(std::string(HEXAPOSE_SOURCE_DIR) + "/resources/platforms/laboratory.toml");
}

inline Eigen::Vector3d onCircle(double radius, double deg) {
    return {radius * std::cos(radiansFromDeg(deg)), radius * std::sin(radiansFromDeg(deg)), 0.0};
}

inline PlatformGeometry withStrokes(PlatformGeometry machine) {
    const LegLengths home = machine.homeLengths();
    for (int i = 0; i < kLegCount; ++i) {
        machine.legs[static_cast<std::size_t>(i)].minLength = 0.5 * home[i];
        machine.legs[static_cast<std::size_t>(i)].maxLength = 1.5 * home[i];
    }
    return machine;
}

/// 3-3: every joint belongs to two legs.
inline PlatformGeometry octahedral() {
    PlatformGeometry machine;
    machine.name = "Octahedral";
    machine.p_OP_home_B = {0.0, 0.0, 0.9};
    for (int i = 0; i < kLegCount; ++i) {
        machine.legs[static_cast<std::size_t>(i)].p_OA_B = onCircle(0.8, 120.0 * ((i + 1) / 2) - 60.0);
        machine.legs[static_cast<std::size_t>(i)].p_PB_P = onCircle(0.5, 120.0 * (i / 2));
    }
    return withStrokes(machine);
}

/// No symmetry, joints out of plane, platform origin beside the joints.
inline PlatformGeometry asymmetric() {
    std::mt19937_64 random(99);
    const auto shift = [&random](double range) {
        return range * (static_cast<double>(random() >> 11) * 0x1p-52 - 1.0);
    };
    PlatformGeometry machine;
    machine.name = "Asymmetric";
    machine.p_OP_home_B = {0.3, -0.1, 2.0};
    for (int i = 0; i < kLegCount; ++i) {
        const double pair = 120.0 * ((i + 1) / 2), top = 120.0 * (i / 2) + 60.0;
        machine.legs[static_cast<std::size_t>(i)].p_OA_B =
            onCircle(1.5 + shift(0.2), pair + (i % 2 == 0 ? 12.0 : -12.0) + shift(8.0)) +
            Eigen::Vector3d(0.0, 0.0, shift(0.2));
        machine.legs[static_cast<std::size_t>(i)].p_PB_P =
            onCircle(0.9 + shift(0.1), top + (i % 2 == 0 ? -10.0 : 10.0) + shift(6.0)) +
            Eigen::Vector3d(-0.2, 0.1, 0.3 + shift(0.1));
    }
    return withStrokes(machine);
}

/// Base and platform are similar regular hexagons: the Jacobian is singular at every pose.
inline PlatformGeometry similarHexagons() {
    PlatformGeometry machine;
    machine.name = "Similar hexagons";
    machine.p_OP_home_B = {0.0, 0.0, 0.5};
    for (int i = 0; i < kLegCount; ++i) {
        machine.legs[static_cast<std::size_t>(i)].p_OA_B = onCircle(0.4, 60.0 * i);
        machine.legs[static_cast<std::size_t>(i)].p_PB_P = onCircle(0.2, 60.0 * i);
    }
    return withStrokes(machine);
}

inline PlatformGeometry scaledBy(double factor, PlatformGeometry machine) {
    machine.name += " x " + std::to_string(factor);
    machine.p_OP_home_B *= factor;
    for (Leg& leg : machine.legs) {
        leg.p_OA_B *= factor;
        leg.p_PB_P *= factor;
        leg.minLength *= factor;
        leg.maxLength *= factor;
    }
    return machine;
}

/// Uniform in +-offset (m), +-angle (rad); seeded and the same with every library.
class RandomPoses {
public:
    RandomPoses(double offset, double angle, std::uint64_t seed) : m_random(seed) {
        m_range << Eigen::Vector3d::Constant(offset), Eigen::Vector3d::Constant(angle);
    }
    Pose next() {
        PoseVector unit;
        for (int i = 0; i < 6; ++i)
            unit[i] = static_cast<double>(m_random() >> 11) * 0x1p-52 - 1.0;
        return Pose::fromVector(unit.cwiseProduct(m_range));
    }

private:
    std::mt19937_64 m_random;
    PoseVector m_range;
};

/// The published sets: 1 is +-10 mm +-10 deg, 2 is +-40 mm +-40 deg.
inline double setRange(int set) {
    return set == 1 ? 10.0 : 40.0;
}
inline RandomPoses publishedPoses(int set, std::uint64_t seed) {
    return {metresFromMm(setRange(set)), radiansFromDeg(setRange(set)), seed};
}

/// Offsets over the machine's size, angles as they are: one number to compare poses by.
inline double distance(const PlatformGeometry& machine, const Pose& a, const Pose& b) {
    const double turn = (rotationMatrix(a.angles) - rotationMatrix(b.angles)).norm() / std::sqrt(2.0);
    return (a.offset - b.offset).norm() / machine.size() + turn;
}

inline LegLengths metres(double l1, double l2, double l3, double l4, double l5, double l6) {
    LegLengths mm;
    mm << l1, l2, l3, l4, l5, l6;
    return mm.unaryExpr(&metresFromMm);
}

} // namespace hexapose::testing
