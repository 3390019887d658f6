// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include <hexapose/core/base/units.h>
#include <hexapose/core/finite_step/finite_step_solver.h>
#include <hexapose/core/finite_step/path_fallback.h>
#include <hexapose/core/finite_step/step_system.h>
#include <hexapose/core/geometry/geometry_file.h>
#include <hexapose/core/kinematics/newton/newton_raphson.h>
#include <hexapose/core/kinematics/regression/mpr_newton.h>
#include <hexapose/core/kinematics/regression/polynomial_training.h>

#include <exception>
#include <iostream>
#include <memory>

namespace {

using hexapose::ForwardResult;
using hexapose::PoseVector;

/// The same platform as a mechanism of points and equations, which the library does not know beforehand.
bool followsAsAMechanism(const hexapose::PlatformGeometry& platform) {
    const hexapose::StepSystem system(hexapose::mechanismOf(platform), "laboratory");
    std::cout << "mechanism: " << system.unknowns() << " unknowns, condition " << system.homeCondition()
              << '\n';
    return system.unknowns() == 12 && system.homeCondition() < 10.0;
}

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
    const bool right =
        followsAsAMechanism(platform) && isRight(hexapose::NewtonRaphson(platform, {})) &&
        isRight(hexapose::FiniteStepSolver(platform, {})) && model &&
        isRight(hexapose::PathFallback(
            platform, std::make_shared<hexapose::MprNewton>(platform, *model, hexapose::NewtonOptions{})));
    std::cout << (right ? "as published\n" : "not as published\n");
    return right ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
