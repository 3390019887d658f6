// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <optional>

namespace hexapose {

/// Where a rigid body is and how it moves: base frame, m and rad.
struct BodyMotion {
    Eigen::Matrix3d R_BP = Eigen::Matrix3d::Identity();
    Eigen::Vector3d p_OP_B = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
    Eigen::Vector3d angularVelocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d angularAcceleration = Eigen::Vector3d::Zero();
};

/// Points of a body, one a column, at home and somewhere else, or their velocities.
using PointColumns = Eigen::Ref<const Eigen::Matrix3Xd>;

/// What is known of a body beforehand.
struct BodyFit {
    Eigen::Vector3d p_OP_home_B = Eigen::Vector3d::Zero(); ///< the point whose motion is asked for, at home
    bool turns = true;                                     ///< false: it only shifts
    std::optional<Eigen::Vector3d> pivot_B = std::nullopt; ///< a point that stays: it only turns about it
};

/// The pose that brings the points at home nearest to those now (least squares; Kabsch). Not turned where the
/// points lie on one line. Allocates nothing.
BodyMotion motionFit(const BodyFit& fit, const PointColumns& home, const PointColumns& now) noexcept;
/// Adds velocities, by least squares over those of the points: v = v_P + omega x r.
void addVelocity(const BodyFit& fit, BodyMotion& body, const PointColumns& now,
                 const PointColumns& velocities) noexcept;
/// Adds accelerations, after the velocities: a = a_P + alpha x r + omega x (omega x r).
void addAcceleration(const BodyFit& fit, BodyMotion& body, const PointColumns& now,
                     const PointColumns& accelerations) noexcept;

} // namespace hexapose
