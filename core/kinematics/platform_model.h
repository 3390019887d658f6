// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"
#include "core/kinematics/jacobian.h"
#include "core/kinematics/leg_equations.h"
#include "core/kinematics/singularity.h"

#include <Eigen/Core>

#include <memory>
#include <string>

namespace hexapose {

/// A machine, and what follows from its geometry alone: computed once, never changed, shared by all who ask.
/// What moves it are its actuators, here the six legs of a 6-UPS platform, and an actuator's coordinate is
/// the length of its leg; a model of cranks or sliders has the same functions with angles or travels instead.
///
/// Frames and units as in PlatformGeometry: base frame B with origin O, platform frame with origin P; a pose
/// is P from home (m) and the rotation R_BP (rad).
class PlatformModel {
public:
    /// geometry: one that validate() accepts; of another the numbers are not to be relied on. Costs some
    /// microseconds, as much as a dozen questions to it: it is made once and shared, and never in passing.
    explicit PlatformModel(const PlatformGeometry& geometry);

    const PlatformGeometry& geometry() const noexcept { return m_geometry; }
    /// The machine's own size, m: the mean leg length at home. Tolerances scale with it.
    double size() const noexcept { return m_equations.size(); }
    /// Lever arm of the rotation, m: root mean square of |p_PB_P|.
    double jointRadius() const noexcept { return m_jointRadius; }
    /// Determinant of the scaled Jacobian at home (no unit), whose sign gives the side of the singular poses;
    /// 0 for a machine that is singular there, see kSingularValueFloor.
    double homeDeterminant() const noexcept { return m_homeDeterminant; }
    /// What a regression model depends on, see PlatformGeometry.
    const std::string& fingerprint() const noexcept { return m_fingerprint; }
    /// The equations without units that solvers work on.
    const LegEquations& equations() const noexcept { return m_equations; }
    /// Strokes: 6x1 each, m, leg 1 first.
    const LegLengths& minActuators() const noexcept { return m_minActuators; }
    const LegLengths& maxActuators() const noexcept { return m_maxActuators; }

    /// 6x1, m, leg 1 first (Eq. 3): | p_home + p + R b_i - A_i |. Knows nothing of strokes.
    LegLengths actuators(const Pose& pose) const;
    /// 3x6, m, base frame, from O: where the platform joints are, p_home + p + R b_i, leg 1 first.
    Eigen::Matrix<double, 3, kLegCount> joints(const Pose& pose) const;
    /// 6x6 (Eq. 8), see geometricJacobian(): actuator rates (m/s) from (v of P, omega), base frame, m/s and
    /// rad/s.
    Jacobian jacobian(const Pose& pose) const;
    /// Of the scaled Jacobian, without units.
    SingularityMeasure singularity(const Pose& pose) const noexcept;
    /// q, the determinant of the scaled Jacobian over that at home: 1 at home, 0 where the side is left; NaN
    /// for a machine that is singular at home.
    double determinantRatio(const Pose& pose) const noexcept;
    /// The same from the determinant that singularity() returns.
    double ratioOf(double determinant) const noexcept;

private:
    LegEquations::Matrix scaledJacobian(const Pose& pose) const noexcept;

    PlatformGeometry m_geometry;
    LegEquations m_equations;
    LegLengths m_minActuators;
    LegLengths m_maxActuators;
    double m_jointRadius;
    std::string m_fingerprint;
    double m_homeDeterminant = 0.0;
};

/// How a model travels.
using SharedModel = std::shared_ptr<const PlatformModel>;

inline SharedModel makeModel(const PlatformGeometry& geometry) {
    return std::make_shared<const PlatformModel>(geometry);
}

} // namespace hexapose
