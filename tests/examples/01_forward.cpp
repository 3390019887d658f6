// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The pose of measured leg lengths, and how far it can be wrong: 01_forward PLATFORM.toml

#include <hexapose/core/base/input_error.h>
#include <hexapose/core/base/units.h>
#include <hexapose/core/geometry/geometry_file.h>
#include <hexapose/core/kinematics/inverse_kinematics.h>
#include <hexapose/core/kinematics/newton/newton_raphson.h>
#include <hexapose/core/kinematics/pose_accuracy.h>

#include <iostream>

int main(int argc, char* argv[]) try {
    if (argc != 2) {
        std::cerr << "usage: 01_forward PLATFORM.toml\n";
        return 2;
    }
    const hexapose::PlatformGeometry platform = hexapose::loadPlatform(argv[1]);
    const hexapose::NewtonRaphson newton(platform, {});

    // Everything inside is in metres and radians; leg 1 first.
    const hexapose::LegLengths lengths =
        hexapose::LegLengths(339.5, 336.5, 336.6, 329.2, 345.1, 334.5).unaryExpr(&hexapose::metresFromMm);
    const hexapose::Pose home; // where the iteration begins
    const hexapose::ForwardResult result = newton.solve(lengths, home);
    std::cout << hexapose::toWord(result.status) << " after " << result.iterations << " iterations\n";
    if (!result.isUsable())
        return 1;

    std::cout << "x y z alpha beta gamma, m and rad: " << result.pose.toVector().transpose() << '\n';
    const auto accuracy = hexapose::poseAccuracy(platform, result.pose, result.residual);
    const auto rounding = hexapose::roundingEffect(platform, result.pose, 1e-4);
    std::cout << "computed to " << accuracy.offsetBound << " m; lengths rounded to 0.1 mm leave "
              << rounding.sigma[0] << " m of x open\n";

    // The way back gives the lengths again.
    const double error = (hexapose::legLengths(platform, result.pose) - lengths).norm();
    return error < 1e-9 ? 0 : 1;
} catch (const hexapose::InputError& error) {
    std::cerr << error.what() << '\n'; // one line: file, line, cause
    return 2;
}
