// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/step_system.h"
#include "core/kinematics/platform_model.h"

#include <Eigen/Core>

#include <array>

namespace hexapose {

/// The step system of a 6-UPS platform, six legs (Front. Mech. Eng. 2025, 20(1):7, Eq. 3) and six distances
/// (Eq. 7) over four marks, in fixed memory; the same numbers as StepSystem gives for mechanismOf(). The
/// distances are solved by hand: what they leave of the twelve unknowns is a shift and a small turn, and six
/// equations for those.
class HexapodSteps {
public:
    /// The four marks, see hexapodMarks(), one a column, base frame, m.
    using Marks = Eigen::Matrix<double, 3, 4>;

    /// Throws InputError when no three platform joints span a triangle.
    explicit HexapodSteps(const PlatformModel& model);

    /// False where the platform is singular at home: then no path can be followed.
    bool isRegularAtHome() const noexcept { return m_homeDeterminant != 0.0; }
    Marks marksAt(const Pose& pose) const noexcept;
    /// By best rigid fit of the six joints and the fourth mark.
    Pose poseOf(const Marks& marks) const noexcept;

    /// Adds to `marks` the step of the legs from `from` to `to` (m), linear in all of them. Returns q where
    /// the step began, signed; the marks stay where it is 0 or NaN. Side: Drive or Closed.
    double step(Marks& marks, const LegLengths& from, const LegLengths& to, StepSide side) const noexcept;
    /// A Newton step to the lengths that moves the marks as one rigid body.
    double rigidStep(Marks& marks, const LegLengths& to) const noexcept;
    /// q there.
    double determinantRatio(const Marks& marks) const noexcept;

private:
    using Legs = Eigen::Array<double, kLegCount, 1>;
    struct Configuration;
    void configure(const Marks& marks, Configuration& at) const noexcept;
    double ratio(const Configuration& at, double determinant) const noexcept;

    Legs m_ax, m_ay, m_az; ///< base joints
    /// Platform joint = first mark + u a + v b + w c, with a, b, c from the first mark to the others.
    Legs m_u, m_v, m_w;
    Eigen::Vector3d m_centre;      ///< u, v, w of the middle of the joints
    Eigen::Matrix3d m_homeSquares; ///< scalar products of a, b, c
    Marks m_homeMarks;
    Eigen::Vector3d m_p_OP_home_B;
    double m_spread;                ///< makes the columns of the turn comparable, m
    double m_homeDeterminant = 0.0; ///< times volume, over the product of the distances
};

} // namespace hexapose
