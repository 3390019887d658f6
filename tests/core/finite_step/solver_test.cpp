// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Finite-step integration behind the interface of the forward solvers.
#include "core/finite_step/finite_step_solver.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "tests/core/finite_step/finite_step_fixture.h"

#include <gtest/gtest.h>

#include <limits>

namespace hexapose::testing::solver_test {
namespace {

TEST(FiniteStepSolver, FindsThePoseItsLengthsComeFrom) {
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric(),
                                            scaledBy(1e-3, laboratory()), scaledBy(1e6, laboratory())}) {
        SCOPED_TRACE(machine.name);
        const FiniteStepSolver solver(machine, {});
        RandomPoses poses(0.06 * machine.size(), radiansFromDeg(10.0), 31);
        for (int i = 0; i < 30; ++i) {
            const Pose truth = poses.next();
            const LegLengths lengths = legLengths(machine, truth);
            const ForwardResult result = solver.solve(lengths, Pose{});
            ASSERT_EQ(result.status, SolveStatus::Converged) << toWord(result.status);
            EXPECT_TRUE(result.accurate && result.isUsable() && result.hasPose());
            EXPECT_EQ(result.iterations, 1000);
            EXPECT_LE(result.residual, defaultTolerance(machine));
            EXPECT_LT(distance(machine, result.pose, truth), 1e-9);
        }
    }
    EXPECT_EQ(FiniteStepSolver(laboratory(), {}).name(), "fsi");
}

TEST(FiniteStepSolver, RefusesWhatAreNoLengths) {
    const PlatformGeometry machine = laboratory();
    const FiniteStepSolver solver(machine, {});
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {std::nan(""), infinity, -infinity, 0.0, -0.3}) {
        LegLengths lengths = machine.homeLengths();
        lengths[2] = bad;
        const ForwardResult result = solver.solve(lengths, Pose{});
        EXPECT_EQ(result.status, SolveStatus::InvalidInput);
        EXPECT_FALSE(result.hasPose() || result.isUsable() || result.pose.isFinite());
    }
    const Pose nowhere{Eigen::Vector3d::Constant(std::nan("")), {}};
    EXPECT_EQ(solver.solve(machine.homeLengths(), nowhere).status, SolveStatus::InvalidInput);
}

TEST(FiniteStepSolver, NeverCallsAnUnreachableSetUsable) {
    const PlatformGeometry machine = laboratory();
    for (const StepForm form : {StepForm::Open, StepForm::Closed, StepForm::Corrected}) {
        const FiniteStepSolver solver(machine, {200, form, 0.0});
        for (const double factor : {1e-3, 30.0, 1e150, 1e300}) {
            LegLengths lengths = machine.homeLengths();
            lengths[2] *= factor;
            EXPECT_EQ(solver.solve(lengths, Pose{}).status, SolveStatus::NoSolution) << factor;
            EXPECT_FALSE(solver.solve(factor * 1e10 * machine.homeLengths(), Pose{}).isUsable()) << factor;
        }
        const ForwardResult fold = solver.solve(metres(400, 320, 400, 320, 400, 320), Pose{});
        EXPECT_EQ(fold.status, SolveStatus::Singular);
        EXPECT_TRUE(fold.hasPose() && !fold.isUsable());
        EXPECT_GT(fold.residual, 1e-3);
        EXPECT_GT(fold.iterations, 150);
        EXPECT_LT(fold.iterations, 200);
    }
}

TEST(FiniteStepSolver, AToleranceIsKept) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const LegLengths lengths = legLengths(machine, kTarget2);
    const auto statusWith = [&](int steps, StepForm form, double tolerance) {
        return FiniteStepSolver(machine, {steps, form, tolerance}).solve(lengths, Pose{}).status;
    };
    EXPECT_EQ(statusWith(100, StepForm::Open, 0.0), SolveStatus::Converged);
    EXPECT_EQ(statusWith(100, StepForm::Open, 1e-6), SolveStatus::IterationLimit);
    EXPECT_EQ(statusWith(1000, StepForm::Closed, 1e-6), SolveStatus::Converged);
}

/// From a pose near by it goes on from there, and says so where Newton's iteration takes what it finds.
TEST(FiniteStepSolver, StaysConnectedToItsStart) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const FiniteStepSolver solver(machine, {});
    Pose from;
    for (int k = 1; k <= 20; ++k) {
        const Pose truth = Pose::fromVector(k / 20.0 * kTarget2.toVector());
        const ForwardResult result = solver.solve(legLengths(machine, truth), from);
        ASSERT_EQ(result.status, SolveStatus::Converged);
        EXPECT_LT(distance(machine, result.pose, truth), 1e-9);
        from = result.pose;
    }
    // Legs of a yaw of 120 deg: the way there crosses a singular pose, and nothing is claimed.
    const LegLengths crossed = legLengths(machine, poseMmDeg(0, 0, 0, 0, 0, 120));
    Pose start;
    bool stopped = false;
    for (int k = 1; k <= 120 && !stopped; ++k) {
        const ForwardResult result = solver.solve(legLengths(machine, poseMmDeg(0, 0, 0, 0, 0, k)), start);
        stopped = result.status == SolveStatus::Singular;
        start = result.pose;
    }
    EXPECT_TRUE(stopped);
    EXPECT_EQ(NewtonRaphson(machine, {}).solve(crossed, Pose{}).status, SolveStatus::Converged);
}

} // namespace
} // namespace hexapose::testing::solver_test
