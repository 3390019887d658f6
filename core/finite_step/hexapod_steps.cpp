// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/hexapod_steps.h"

#include "core/finite_step/mechanism.h"
#include "core/finite_step/rigid_fit.h"
#include "core/kinematics/linear_system.h"
#include "core/kinematics/newton/newton_raphson.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace hexapose {

namespace {

using Columns = Eigen::Matrix<double, 3, kLegCount + 1>;

/// From the first mark to the others.
Eigen::Matrix3d sidesOf(const HexapodSteps::Marks& marks) noexcept {
    return marks.rightCols<3>().colwise() - marks.col(0);
}

} // namespace

/// Everything that a step needs of where the marks are.
struct HexapodSteps::Configuration {
    Eigen::Vector3d centre;
    Eigen::Matrix3d sides;   ///< a, b, c
    Eigen::Matrix3d squares; ///< their scalar products
    Legs ex, ey, ez, length; ///< unit vectors along the legs
    LinearSystem system;     ///< e . v + (r x e) . turn = right, the turn times the spread
};

HexapodSteps::HexapodSteps(const PlatformModel& model) : m_p_OP_home_B(model.geometry().p_OP_home_B) {
    const PlatformGeometry& geometry = model.geometry();
    const HexapodMarks marks = hexapodMarks(geometry);
    for (std::size_t k = 0; k < 3; ++k)
        m_homeMarks.col(static_cast<Eigen::Index>(k)) =
            geometry.p_OP_home_B + geometry.legs[marks.legs[k]].p_PB_P;
    m_homeMarks.col(3) = marks.fourth_B;
    const Eigen::Matrix3d sides = sidesOf(m_homeMarks);
    const Eigen::Matrix3d inverse = sides.inverse();
    m_centre.setZero();
    for (int i = 0; i < kLegCount; ++i) {
        const Leg& leg = geometry.legs[static_cast<std::size_t>(i)];
        const Eigen::Vector3d parts = inverse * (geometry.p_OP_home_B + leg.p_PB_P - m_homeMarks.col(0));
        m_u[i] = parts[0];
        m_v[i] = parts[1];
        m_w[i] = parts[2];
        m_ax[i] = leg.p_OA_B[0];
        m_ay[i] = leg.p_OA_B[1];
        m_az[i] = leg.p_OA_B[2];
        m_centre += parts / kLegCount;
    }
    m_homeSquares = sides.transpose() * sides;
    double square = 0.0;
    for (const Leg& leg : geometry.legs)
        square += (geometry.p_OP_home_B + leg.p_PB_P - m_homeMarks.col(0) - sides * m_centre).squaredNorm();
    m_spread = std::sqrt(square / kLegCount);
    if (model.homeDeterminant() == 0.0)
        return;
    m_homeDeterminant = 1.0;
    m_homeDeterminant = determinantRatio(m_homeMarks);
}

HexapodSteps::Marks HexapodSteps::marksAt(const Pose& pose) const noexcept {
    const Eigen::Matrix3d R_BP = rotationMatrix(pose.angles);
    return (R_BP * (m_homeMarks.colwise() - m_p_OP_home_B)).colwise() + (m_p_OP_home_B + pose.offset);
}

Pose HexapodSteps::poseOf(const Marks& marks) const noexcept {
    const auto pointsOf = [this](const Marks& from) {
        const Eigen::Matrix3d sides = sidesOf(from);
        Columns points;
        for (int i = 0; i < kLegCount; ++i)
            points.col(i) = from.col(0) + sides * Eigen::Vector3d(m_u[i], m_v[i], m_w[i]);
        points.col(kLegCount) = from.col(3);
        return points;
    };
    const Columns home = pointsOf(m_homeMarks), now = pointsOf(marks);
    const BodyMotion body = motionFit({m_p_OP_home_B}, home, now);
    return {body.p_OP_B - m_p_OP_home_B, eulerAngles(body.R_BP)};
}

void HexapodSteps::configure(const Marks& marks, Configuration& at) const noexcept {
    at.sides = sidesOf(marks);
    at.squares.noalias() = at.sides.transpose() * at.sides;
    const Eigen::Vector3d arm = at.sides * m_centre; // of the centre, from the first mark
    at.centre = marks.col(0) + arm;
    const auto joints = [&](Eigen::Index k) -> Legs {
        return m_u * at.sides(k, 0) + m_v * at.sides(k, 1) + m_w * at.sides(k, 2) - arm[k];
    };
    const Legs rx = joints(0), ry = joints(1), rz = joints(2); // from the centre
    const Legs dx = rx + at.centre[0] - m_ax, dy = ry + at.centre[1] - m_ay, dz = rz + at.centre[2] - m_az;
    at.length = (dx.square() + dy.square() + dz.square()).sqrt();
    const Legs inverse = at.length.inverse();
    at.ex = dx * inverse;
    at.ey = dy * inverse;
    at.ez = dz * inverse;
    const double scale = 1.0 / m_spread;
    at.system[0] = at.ex;
    at.system[1] = at.ey;
    at.system[2] = at.ez;
    at.system[3] = (ry * at.ez - rz * at.ey) * scale;
    at.system[4] = (rz * at.ex - rx * at.ez) * scale;
    at.system[5] = (rx * at.ey - ry * at.ex) * scale;
}

/// As the 12x12 matrix with normalised rows has it: the distance rows stretch with the marks where these
/// drift.
double HexapodSteps::ratio(const Configuration& at, double determinant) const noexcept {
    const Eigen::Matrix3d& g = at.squares;
    const double distances = g(0, 0) * g(1, 1) * g(2, 2) * (g(0, 0) + g(1, 1) - 2.0 * g(0, 1)) *
                             (g(1, 1) + g(2, 2) - 2.0 * g(1, 2)) * (g(2, 2) + g(0, 0) - 2.0 * g(2, 0));
    const double volume = at.sides.col(0).cross(at.sides.col(1)).dot(at.sides.col(2));
    return determinant * volume / (m_homeDeterminant * std::sqrt(distances));
}

double HexapodSteps::determinantRatio(const Marks& marks) const noexcept {
    Configuration at;
    configure(marks, at);
    at.system[6].setZero();
    Eigen::Matrix<double, 6, 1> unused;
    return ratio(at, solveLinearSystem(at.system, unused));
}

double HexapodSteps::step(Marks& marks, const LegLengths& from, const LegLengths& to,
                          StepSide side) const noexcept {
    Configuration at;
    configure(marks, at);
    Eigen::Matrix3d stretch = Eigen::Matrix3d::Zero(); // of the sides
    if (side == StepSide::Drive) {
        at.system[6] = to.array() - from.array();
    } else {
        // Back to the distances at home, the first mark staying: a strain E with E a = da makes the scalar
        // products change by 2 a . E b. Any other such stretch differs by a turn, which the equations find.
        Eigen::Matrix3d inverseTransposed;
        inverseTransposed << at.sides.col(1).cross(at.sides.col(2)), at.sides.col(2).cross(at.sides.col(0)),
            at.sides.col(0).cross(at.sides.col(1));
        const double volume = at.sides.col(0).dot(inverseTransposed.col(0));
        stretch.noalias() = inverseTransposed * ((0.5 / volume) * (m_homeSquares - at.squares));
        const auto shift = [&](Eigen::Index k) -> Legs {
            return m_u * stretch(k, 0) + m_v * stretch(k, 1) + m_w * stretch(k, 2);
        };
        at.system[6] = to.array() - at.length - (at.ex * shift(0) + at.ey * shift(1) + at.ez * shift(2));
    }
    Eigen::Matrix<double, 6, 1> x;
    const double determinant = solveLinearSystem(at.system, x);
    if (!(std::abs(determinant) > 0.0))
        return determinant;
    const Eigen::Vector3d turn = x.tail<3>() / m_spread;
    const Eigen::Vector3d first = x.head<3>() + turn.cross(Eigen::Vector3d(marks.col(0) - at.centre));
    marks.col(0) += first;
    for (Eigen::Index k = 0; k < 3; ++k)
        marks.col(k + 1) += first + turn.cross(at.sides.col(k)) + stretch.col(k);
    return ratio(at, determinant);
}

double HexapodSteps::rigidStep(Marks& marks, const LegLengths& to) const noexcept {
    Configuration at;
    configure(marks, at);
    at.system[6] = to.array() - at.length;
    Eigen::Matrix<double, 6, 1> x;
    const double determinant = solveLinearSystem(at.system, x);
    if (!(std::abs(determinant) > 0.0))
        return determinant;
    // The turn by its quaternion (1, turn / 2): exact to third order, a rotation to the last digit.
    const Eigen::Vector3d half = x.tail<3>() / (2.0 * m_spread);
    const double scale = 2.0 / (1.0 + half.squaredNorm());
    const Eigen::Vector3d place = at.centre + x.head<3>();
    for (Eigen::Index k = 0; k < 4; ++k) {
        const Eigen::Vector3d arm = marks.col(k) - at.centre;
        const Eigen::Vector3d side = half.cross(arm);
        marks.col(k) = place + arm + scale * (side + half.cross(side));
    }
    return ratio(at, determinant);
}

} // namespace hexapose
