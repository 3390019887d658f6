// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Compiled twice: as the programs are, and for this very processor. The second must not share Eigen's
// functions with the rest of the program, and so its Eigen has another name.
#ifdef HEXAPOSE_YARDSTICK_NATIVE
#define Eigen EigenNative
#endif
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace hexapose::bench {

struct YardstickMachine {
    double base[6][3];
    double joint[6][3];
    double home[3];
};

#ifdef HEXAPOSE_YARDSTICK_NATIVE
int plainNewtonNative(const YardstickMachine& machine, const double* lengths, double* pose,
                      double tolerance) {
#else
int plainNewton(const YardstickMachine& machine, const double* lengths, double* pose, double tolerance) {
#endif
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    Vector6 x = Vector6::Map(pose);
    for (int iteration = 0; iteration < 50; ++iteration) {
        const double ca = std::cos(x[3]), sa = std::sin(x[3]);
        const double cb = std::cos(x[4]), sb = std::sin(x[4]);
        const double cg = std::cos(x[5]), sg = std::sin(x[5]);
        Eigen::Matrix3d R, E;
        R << cg * cb, cg * sb * sa - sg * ca, cg * sb * ca + sg * sa, //
            sg * cb, sg * sb * sa + cg * ca, sg * sb * ca - cg * sa,  //
            -sb, cb * sa, cb * ca;
        E << cg * cb, -sg, 0.0, sg * cb, cg, 0.0, -sb, 0.0, 1.0;
        const Eigen::Vector3d origin = Eigen::Vector3d::Map(machine.home) + x.head<3>();
        Matrix6 J;
        Vector6 error;
        for (int i = 0; i < 6; ++i) {
            const Eigen::Vector3d arm = R * Eigen::Vector3d::Map(machine.joint[i]);
            const Eigen::Vector3d d = origin + arm - Eigen::Vector3d::Map(machine.base[i]);
            const double length = d.norm();
            const Eigen::Vector3d n = d / length;
            J.row(i) << n.transpose(), arm.cross(n).transpose();
            error[i] = lengths[i] - length;
        }
        if (error.norm() <= tolerance) {
            Vector6::Map(pose) = x;
            return iteration;
        }
        J.rightCols<3>() = (J.rightCols<3>() * E).eval();
        x += Eigen::PartialPivLU<Matrix6>(J).solve(error);
    }
    return -1;
}

} // namespace hexapose::bench
