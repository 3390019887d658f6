// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include <hexapose/core/geometry/geometry_file.h>
#include <hexapose/core/geometry/units.h>
#include <hexapose/core/kinematics/mpr_newton.h>
#include <hexapose/core/kinematics/newton_raphson.h>
#include <hexapose/core/kinematics/polynomial_training.h>

#include <exception>
#include <iostream>

namespace {

using hexapose::ForwardResult;
using hexapose::PoseVector;

/// The published measurement: its lengths, and their pose to the digits that the lengths are good for.
const hexapose::LegLengths kLengths =
    hexapose::LegLengths(339.5, 336.5, 336.6, 329.2, 345.1, 334.5).unaryExpr(&hexapose::metresFromMm);
const PoseVector kPose(11.99e-3, -4.04e-3, 39.78e-3, -1.686e-4, 5.838e-5, 0.08689);
/// Half a unit of the last digit of each.
const PoseVector kTolerance(0.005e-3, 0.005e-3, 0.005e-3, 0.5e-7, 0.5e-8, 0.5e-5);

bool isRight(const hexapose::ForwardSolver& solver) {
    const ForwardResult result = solver.solve(kLengths, {});
    const PoseVector pose = result.pose.toVector();
    std::cout << solver.name() << ": " << hexapose::toWord(result.status) << ", " << pose.transpose() << '\n';
    return result.isUsable() && ((pose - kPose).cwiseAbs().array() <= kTolerance.array()).all();
}

} // namespace

int main(int argc, char* argv[]) try {
    if (argc != 2) {
        std::cerr << "usage: consumer PLATFORM.toml\n";
        return 2;
    }
    const hexapose::PlatformGeometry platform = hexapose::loadPlatform(argv[1]);
    hexapose::TrainingSpec spec = hexapose::defaultTrainingSpec(platform, 3);
    spec.samples = 5000;
    const auto model = hexapose::trainModel(platform, spec);
    const bool right = isRight(hexapose::NewtonRaphson(platform, {})) && model &&
                       isRight(hexapose::MprNewton(platform, *model, {}));
    std::cout << (right ? "as published\n" : "not as published\n");
    return right ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
