// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/finite_step/rigid_fit.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace hexapose {

namespace {

/// Points nearer to one line than this part of their extent leave the turn about it open.
constexpr double kCollinear = 1e-9;

Eigen::Vector3d mean(const PointColumns& points) noexcept {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < points.cols(); ++i)
        sum += points.col(i);
    return sum / static_cast<double>(points.cols());
}

/// What the body turns about, and how that moves.
Eigen::Vector3d centreOf(const BodyFit& fit, const PointColumns& points) noexcept {
    return fit.pivot_B ? *fit.pivot_B : mean(points);
}
Eigen::Vector3d centreRate(const BodyFit& fit, const PointColumns& rates) noexcept {
    return fit.pivot_B ? Eigen::Vector3d::Zero() : mean(rates);
}

/// Of vectors at arms from the centre: the omega for which omega x arm comes nearest to them.
struct Moments {
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();

    void add(const Eigen::Vector3d& arm, const Eigen::Vector3d& vector) noexcept {
        inertia += arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose();
        spin += arm.cross(vector);
    }
    Eigen::Vector3d turn() const noexcept { return inertia.inverse() * spin; }
};

/// Kabsch.
Eigen::Matrix3d rotationFit(const PointColumns& home, const Eigen::Vector3d& homeCentre,
                            const PointColumns& now, const Eigen::Vector3d& centre) noexcept {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (Eigen::Index i = 0; i < home.cols(); ++i)
        covariance += (now.col(i) - centre) * (home.col(i) - homeCentre).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (!(svd.singularValues()[1] > kCollinear * svd.singularValues()[0]))
        return Eigen::Matrix3d::Identity();
    Eigen::Matrix3d U = svd.matrixU();
    if (U.determinant() * svd.matrixV().determinant() < 0.0)
        U.col(2) = -U.col(2); // a rotation, no reflection
    return U * svd.matrixV().transpose();
}

} // namespace

BodyMotion motionFit(const BodyFit& fit, const PointColumns& home, const PointColumns& now) noexcept {
    const Eigen::Vector3d homeCentre = centreOf(fit, home), centre = centreOf(fit, now);
    BodyMotion body;
    if (fit.turns)
        body.R_BP = rotationFit(home, homeCentre, now, centre);
    body.p_OP_B = centre + body.R_BP * (fit.p_OP_home_B - homeCentre);
    return body;
}

void addVelocity(const BodyFit& fit, BodyMotion& body, const PointColumns& now,
                 const PointColumns& velocities) noexcept {
    const Eigen::Vector3d centre = centreOf(fit, now), shift = centreRate(fit, velocities);
    Moments moments;
    for (Eigen::Index i = 0; i < now.cols() && fit.turns; ++i)
        moments.add(now.col(i) - centre, velocities.col(i) - shift);
    if (fit.turns)
        body.angularVelocity = moments.turn();
    body.velocity = shift + body.angularVelocity.cross(body.p_OP_B - centre);
}

void addAcceleration(const BodyFit& fit, BodyMotion& body, const PointColumns& now,
                     const PointColumns& accelerations) noexcept {
    const Eigen::Vector3d centre = centreOf(fit, now), shift = centreRate(fit, accelerations);
    const Eigen::Vector3d& omega = body.angularVelocity;
    Moments moments;
    for (Eigen::Index i = 0; i < now.cols() && fit.turns; ++i) {
        const Eigen::Vector3d arm = now.col(i) - centre;
        moments.add(arm, accelerations.col(i) - shift - omega.cross(omega.cross(arm)));
    }
    if (fit.turns)
        body.angularAcceleration = moments.turn();
    const Eigen::Vector3d arm = body.p_OP_B - centre;
    body.acceleration = shift + body.angularAcceleration.cross(arm) + omega.cross(omega.cross(arm));
}

} // namespace hexapose
