// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Three solvers on the published measurement: MPR-NR with its fallback, Newton-Raphson, finite-step
// integration: 03_mpr_nr PLATFORM.toml

#include <hexapose/core/base/input_error.h>
#include <hexapose/core/base/units.h>
#include <hexapose/core/finite_step/finite_step_solver.h>
#include <hexapose/core/finite_step/path_fallback.h>
#include <hexapose/core/geometry/geometry_file.h>
#include <hexapose/core/kinematics/newton/newton_raphson.h>
#include <hexapose/core/kinematics/regression/mpr_newton.h>
#include <hexapose/core/kinematics/regression/polynomial_training.h>

#include <iostream>
#include <memory>

namespace {

using hexapose::PoseVector;

/// The published lengths, and their pose to the digits that they are good for.
const hexapose::LegLengths kLengths =
    hexapose::LegLengths(339.5, 336.5, 336.6, 329.2, 345.1, 334.5).unaryExpr(&hexapose::metresFromMm);
const PoseVector kPose(11.99e-3, -4.04e-3, 39.78e-3, -1.686e-4, 5.838e-5, 0.08689);
/// Half a unit of the last digit of each.
const PoseVector kTolerance(0.005e-3, 0.005e-3, 0.005e-3, 0.5e-7, 0.5e-8, 0.5e-5);

bool isRight(const hexapose::ForwardSolver& solver) {
    const hexapose::ForwardResult result = solver.solve(kLengths, {});
    const PoseVector pose = result.pose.toVector();
    std::cout << solver.name() << ": " << hexapose::toWord(result.status) << ", " << result.iterations
              << " iterations, " << pose.transpose() << '\n';
    return result.isUsable() && ((pose - kPose).cwiseAbs().array() <= kTolerance.array()).all();
}

} // namespace

int main(int argc, char* argv[]) try {
    if (argc != 2) {
        std::cerr << "usage: 03_mpr_nr PLATFORM.toml\n";
        return 2;
    }
    const hexapose::PlatformGeometry platform = hexapose::loadPlatform(argv[1]);

    // 100,000 poses within the platform's own range take 0.2 s; loadOrTrainModel() keeps the result in a
    // file.
    const auto model = hexapose::trainModel(platform, hexapose::TrainingSpec{});
    const auto mpr = std::make_shared<hexapose::MprNewton>(platform, *model, hexapose::NewtonOptions{});
    // Where MPR-NR may have found a wrong solution, the legs are tracked from the start.
    const hexapose::PathFallback withFallback(platform, mpr);

    const bool right = isRight(withFallback) && isRight(hexapose::NewtonRaphson(platform, {})) &&
                       isRight(hexapose::FiniteStepSolver(platform, {}));
    std::cout << (right ? "as published\n" : "not as published\n");
    return right ? 0 : 1;
} catch (const hexapose::InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
