// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/pose_accuracy.h"

#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/jacobian.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapose {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// No leg may become shorter than this part of itself within the bound, as the second derivative grows then.
constexpr double kLeastLength = 0.9;
/// Roundings on the way to a length, and to an angle, in units of the last digit.
constexpr double kRoundings = 16.0 * std::numeric_limits<double>::epsilon();

} // namespace

RoundingEffect roundingEffect(const PlatformGeometry& geometry, const Pose& pose, double resolution) {
    const Eigen::FullPivLU<Jacobian> lu(analyticJacobian(geometry, pose));
    const Jacobian inverse = lu.isInvertible() ? Jacobian(lu.inverse()) : Jacobian::Constant(kInfinity);
    return {inverse.cwiseAbs().rowwise().sum() * (resolution / 2.0),
            inverse.rowwise().norm() * (resolution / std::sqrt(12.0))};
}

PoseAccuracy poseAccuracy(const PlatformModel& model, const Pose& pose, double residual) {
    const SingularityMeasure measure = model.singularity(pose);
    PoseAccuracy accuracy{measure.smallestSingularValue, measure.condition, kInfinity, kInfinity};

    const PlatformGeometry& geometry = model.geometry();
    const LegEquations& equations = model.equations();
    const double size = equations.size(), spread = equations.spread();
    const Eigen::Vector3d& centroid = equations.centroidInP(); // machine sizes
    double reach = geometry.p_OP_home_B.norm() + pose.offset.norm();
    for (const Leg& leg : geometry.legs)
        reach = std::max({reach, leg.p_OA_B.norm(), leg.p_PB_P.norm()});
    const LegLengths lengths = legLengths(geometry, pose) / size;
    const double sigma = measure.smallestSingularValue;
    double second = 0.0, mostMotion = kInfinity;
    for (int i = 0; i < kLegCount; ++i) {
        const double arm = (geometry.legs[static_cast<std::size_t>(i)].p_PB_P / size - centroid).norm();
        const double speed2 =
            1.0 + (arm / spread) * (arm / spread); // of the joint, for a motion of unit extent
        const double k = speed2 / (kLeastLength * lengths[i]) + arm / (spread * spread);
        second += k * k;
        mostMotion = std::min(mostMotion, (1.0 - kLeastLength) * lengths[i] / std::sqrt(speed2));
    }
    second = std::sqrt(second);
    const double error = (residual + kRoundings * std::sqrt(6.0) * reach) / size;
    const double discriminant = sigma * sigma - 2.0 * second * error;
    if (!(discriminant > 0.0))
        return accuracy;
    const double motion = 2.0 * error / (sigma + std::sqrt(discriminant));
    if (!(motion <= mostMotion))
        return accuracy;
    const double lever = centroid.norm() / spread;
    accuracy.offsetBound = motion * std::sqrt(1.0 + lever * lever) * size + kRoundings * reach;
    accuracy.angleBound = motion / spread + kRoundings;
    return accuracy;
}

} // namespace hexapose
