// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"
#include "core/kinematics/linear_system.h"

#include <Eigen/Core>

namespace hexapose {

/// Part of the solvers' inside, as all in this header. Where the platform is there: the centroid of the
/// platform joints and a unit quaternion (w, v) of R_BP. Lengths in machine sizes.
struct Placement {
    Eigen::Vector3d centroid;
    double w;
    Eigen::Vector3d v;
};

/// The six equations |d_i| = l_i (Eq. 3) of a machine, without units: lengths are divided by the machine's
/// size, so that micrometres and kilometres give the same numbers, and moments are taken about the centroid
/// of the platform joints and divided by their spread about it, so that the choice of the platform origin P
/// does not matter.
class LegEquations {
public:
    using Legs = Eigen::Array<double, kLegCount, 1>;
    /// Leg vectors d = centroid + R b - a, arms R b, lengths |d| and what is missing of the target lengths.
    struct Evaluation {
        Legs dx, dy, dz, rx, ry, rz, length, error;
        double residual; ///< norm of error
    };
    using Step =
        Eigen::Matrix<double, 6, 1>; ///< centroid displacement, then rotation vector times the joint spread
    using Matrix = Eigen::Matrix<double, kLegCount, 6>;

    explicit LegEquations(const PlatformGeometry& geometry);

    double size() const noexcept { return m_size; }
    double spread() const noexcept { return m_spread; }
    const Eigen::Vector3d& centroidInP() const noexcept { return m_centroidInP; }
    /// P at home from O, base frame.
    const Eigen::Vector3d& home() const noexcept { return m_home; }
    /// Base joints from O, base frame, and platform joints from their centroid, platform frame.
    Eigen::Vector3d base(int leg) const noexcept { return {m_ax[leg], m_ay[leg], m_az[leg]}; }
    Eigen::Vector3d joint(int leg) const noexcept { return {m_bx[leg], m_by[leg], m_bz[leg]}; }
    Legs scaled(const LegLengths& lengths) const noexcept { return lengths.array() / m_size; }

    Placement placementOf(const Pose& pose) const noexcept;
    Pose poseOf(const Placement& placement) const noexcept;

    Evaluation evaluate(const Placement& placement, const Legs& target) const noexcept;
    /// The Jacobian (Eq. 8), 6x6, rows of unit leg vectors and their scaled moments; its Frobenius norm is at
    /// most sqrt(12).
    Matrix jacobian(const Evaluation& at) const noexcept;
    /// The Newton step (Eq. 14) at `at`; returns the determinant of jacobian(at), 0 when there is no step.
    double newtonStep(const Evaluation& at, Step& step) const noexcept;
    /// The placement moved by a step; the rotation by its Cayley transform (no trigonometry, exact to third
    /// order).
    Placement moved(const Placement& from, const Step& step) const noexcept;
    /// How much, at most, the Frobenius norm of the Jacobian changes over a step of this norm.
    double jacobianChange(const Evaluation& at, double stepNorm) const noexcept;

    /// Sign of the Jacobian's determinant, which gives the side of the singular surface; 0 where the smallest
    /// singular value is below the floor.
    double branchSign(const Evaluation& at, double singularValueFloor) const noexcept;

    /// Surely no pose has these lengths: two break a triangle inequality, | |d_i| - |d_j| | <= |A_i A_j| +
    /// |B_i B_j|, or they are so long that their products are no numbers.
    bool areUnreachable(const Legs& target, double slack) const noexcept;

private:
    double m_size;
    double m_spread; ///< rms distance of the platform joints from their centroid
    Eigen::Vector3d m_centroidInP, m_home;
    Legs m_ax, m_ay, m_az, m_bx, m_by, m_bz;
    Eigen::Matrix<double, kLegCount, kLegCount> m_reach; ///< |A_i A_j| + |B_i B_j|
};

/// Lower bound of the smallest singular value from the determinant, with the Frobenius norm at most sqrt(12)
/// (Yu and Gu, 1997).
inline double singularValueBound(double determinant) noexcept {
    constexpr double kFactor = 0.11205; // (5/12)^(5/2), rounded down
    return kFactor * std::abs(determinant);
}

} // namespace hexapose
