// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/leg_equations.h"

#include "core/geometry/singular_values.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace hexapose {

namespace {

Eigen::Matrix3d rotationOf(const Placement& at) {
    const double x = at.v[0], y = at.v[1], z = at.v[2], w = at.w;
    Eigen::Matrix3d R;
    R << 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y), //
        2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x),  //
        2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y);
    return R;
}

} // namespace

LegEquations::LegEquations(const PlatformGeometry& geometry) : m_size(geometry.size()) {
    m_centroidInP.setZero();
    for (const Leg& leg : geometry.legs)
        m_centroidInP += leg.p_PB_P / kLegCount;
    double sum = 0.0;
    for (int i = 0; i < kLegCount; ++i) {
        const Leg& leg = geometry.legs[static_cast<std::size_t>(i)];
        const Eigen::Vector3d a = leg.p_OA_B / m_size, b = (leg.p_PB_P - m_centroidInP) / m_size;
        m_ax[i] = a[0], m_ay[i] = a[1], m_az[i] = a[2];
        m_bx[i] = b[0], m_by[i] = b[1], m_bz[i] = b[2];
        sum += b.squaredNorm();
    }
    m_spread = std::sqrt(sum / kLegCount);
    m_centroidInP /= m_size;
    m_home = geometry.p_OP_home_B / m_size;
    for (int i = 0; i < kLegCount; ++i)
        for (int j = 0; j < kLegCount; ++j)
            m_reach(i, j) = std::hypot(m_ax[i] - m_ax[j], m_ay[i] - m_ay[j], m_az[i] - m_az[j]) +
                            std::hypot(m_bx[i] - m_bx[j], m_by[i] - m_by[j], m_bz[i] - m_bz[j]);
}

Placement LegEquations::placementOf(const Pose& pose) const noexcept {
    const double ca = std::cos(0.5 * pose.angles.alpha), sa = std::sin(0.5 * pose.angles.alpha);
    const double cb = std::cos(0.5 * pose.angles.beta), sb = std::sin(0.5 * pose.angles.beta);
    const double cg = std::cos(0.5 * pose.angles.gamma), sg = std::sin(0.5 * pose.angles.gamma);
    Placement at;
    at.w = cg * cb * ca + sg * sb * sa;
    at.v = {cg * cb * sa - sg * sb * ca, cg * sb * ca + sg * cb * sa, sg * cb * ca - cg * sb * sa};
    at.centroid = m_home + pose.offset / m_size + rotationOf(at) * m_centroidInP;
    return at;
}

Pose LegEquations::poseOf(const Placement& placement) const noexcept {
    const Eigen::Matrix3d R = rotationOf(placement);
    return {(placement.centroid - R * m_centroidInP - m_home) * m_size, eulerAngles(R)};
}

LegEquations::Evaluation LegEquations::evaluate(const Placement& placement,
                                                const Legs& target) const noexcept {
    const Eigen::Matrix3d R = rotationOf(placement);
    Evaluation at;
    at.rx = R(0, 0) * m_bx + R(0, 1) * m_by + R(0, 2) * m_bz;
    at.ry = R(1, 0) * m_bx + R(1, 1) * m_by + R(1, 2) * m_bz;
    at.rz = R(2, 0) * m_bx + R(2, 1) * m_by + R(2, 2) * m_bz;
    at.dx = placement.centroid[0] + at.rx - m_ax;
    at.dy = placement.centroid[1] + at.ry - m_ay;
    at.dz = placement.centroid[2] + at.rz - m_az;
    at.length = (at.dx * at.dx + at.dy * at.dy + at.dz * at.dz).sqrt();
    at.error = target - at.length;
    at.residual = std::sqrt(at.error.square().sum());
    return at;
}

LegEquations::Matrix LegEquations::jacobian(const Evaluation& at) const noexcept {
    const Legs moment = 1.0 / (at.length * m_spread);
    Matrix J;
    J.col(0) = at.dx / at.length;
    J.col(1) = at.dy / at.length;
    J.col(2) = at.dz / at.length;
    J.col(3) = (at.ry * at.dz - at.rz * at.dy) * moment;
    J.col(4) = (at.rz * at.dx - at.rx * at.dz) * moment;
    J.col(5) = (at.rx * at.dy - at.ry * at.dx) * moment;
    return J;
}

double LegEquations::newtonStep(const Evaluation& at, Step& step) const noexcept {
    // Rows are left multiplied by |d_i|, which saves the divisions and changes only the determinant.
    const double s = 1.0 / m_spread;
    LinearSystem system{at.dx,
                        at.dy,
                        at.dz,
                        s * (at.ry * at.dz - at.rz * at.dy),
                        s * (at.rz * at.dx - at.rx * at.dz),
                        s * (at.rx * at.dy - at.ry * at.dx),
                        at.length * at.error};
    const double determinant = solveLinearSystem(system, step) / at.length.prod();
    if (!(determinant != 0.0) || !std::isfinite(determinant))
        return 0.0;
    return determinant;
}

Placement LegEquations::moved(const Placement& from, const Step& step) const noexcept {
    const Eigen::Vector3d half = step.tail<3>() * (0.5 / m_spread);
    Placement to;
    to.centroid = from.centroid + step.head<3>();
    to.w = from.w - half.dot(from.v);
    to.v = from.v + from.w * half + half.cross(from.v);
    const double scale = 1.0 / std::sqrt(to.w * to.w + to.v.squaredNorm());
    to.w *= scale;
    to.v *= scale;
    return to;
}

double LegEquations::jacobianChange(const Evaluation& at, double stepNorm) const noexcept {
    // A joint moves by at most |v| + |b||omega|, |b| <= sqrt(6) spread; a unit leg vector turns by that over
    // |d|.
    constexpr double kFactor = 30.0;
    return kFactor * stepNorm * (1.0 / m_spread + 1.0 / at.length.minCoeff());
}

double LegEquations::branchSign(const Evaluation& at, double singularValueFloor) const noexcept {
    const Matrix J = jacobian(at);
    const double determinant = J.allFinite() ? J.determinant() : 0.0;
    if (singularValueBound(determinant) >
        singularValueFloor) // nearly always, and much cheaper than the values
        return std::copysign(1.0, determinant);
    if (determinant == 0.0 || singularValues(J)[5] < singularValueFloor)
        return 0.0;
    return std::copysign(1.0, determinant);
}

bool LegEquations::areUnreachable(const Legs& target, double slack) const noexcept {
    constexpr double kLongest = 1e50; // machine sizes
    if (!(target.maxCoeff() <= kLongest))
        return true;
    for (int i = 0; i < kLegCount; ++i)
        for (int j = i + 1; j < kLegCount; ++j)
            if (std::abs(target[i] - target[j]) > m_reach(i, j) + slack)
                return true;
    return false;
}

} // namespace hexapose
