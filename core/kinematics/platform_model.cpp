// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/platform_model.h"

#include "core/kinematics/inverse_kinematics.h"

#include <limits>

namespace hexapose {

PlatformModel::PlatformModel(const PlatformGeometry& geometry)
    : m_geometry(geometry), m_equations(geometry), m_jointRadius(geometry.jointRadius()),
      m_fingerprint(geometry.fingerprint()) {
    const SingularityMeasure home = singularity(Pose{});
    m_homeDeterminant = home.smallestSingularValue > kSingularValueFloor ? home.determinant : 0.0;
    for (int i = 0; i < kLegCount; ++i) {
        const Leg& leg = geometry.legs[static_cast<std::size_t>(i)];
        m_minActuators[i] = leg.minLength;
        m_maxActuators[i] = leg.maxLength;
    }
}

LegLengths PlatformModel::actuators(const Pose& pose) const {
    return legLengths(m_geometry, pose);
}

Eigen::Matrix<double, 3, kLegCount> PlatformModel::joints(const Pose& pose) const {
    const Eigen::Matrix3d R = rotationMatrix(pose.angles);
    const Eigen::Vector3d origin = m_geometry.p_OP_home_B + pose.offset;
    Eigen::Matrix<double, 3, kLegCount> joints;
    for (int i = 0; i < kLegCount; ++i)
        joints.col(i) = origin + R * m_geometry.legs[static_cast<std::size_t>(i)].p_PB_P;
    return joints;
}

Jacobian PlatformModel::jacobian(const Pose& pose) const {
    return geometricJacobian(m_geometry, pose);
}

LegEquations::Matrix PlatformModel::scaledJacobian(const Pose& pose) const noexcept {
    return m_equations.jacobian(
        m_equations.evaluate(m_equations.placementOf(pose), LegEquations::Legs::Zero()));
}

SingularityMeasure PlatformModel::singularity(const Pose& pose) const noexcept {
    return singularityOf(scaledJacobian(pose));
}

double PlatformModel::determinantRatio(const Pose& pose) const noexcept {
    return ratioOf(determinantOf(scaledJacobian(pose)));
}

double PlatformModel::ratioOf(double determinant) const noexcept {
    return m_homeDeterminant != 0.0 ? determinant / m_homeDeterminant
                                    : std::numeric_limits<double>::quiet_NaN();
}

SingularityMeasure singularityMeasure(const PlatformGeometry& geometry, const Pose& pose) {
    return PlatformModel(geometry).singularity(pose);
}

} // namespace hexapose
