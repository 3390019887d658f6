// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/kinematics/newton/newton_raphson.h"

#include "core/kinematics/singularity.h"
#include "test_machines.h"
#include "tests/support/sample_count.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace hexapose;
using namespace hexapose::testing;

namespace {

SolveStatus statusOf(const ForwardSolver& solver, const LegLengths& lengths, const Pose& start = {}) {
    return solver.solve(lengths, start).status;
}

Pose level(double z, double yawDeg) {
    return {{0.0, 0.0, z}, {0.0, 0.0, radiansFromDeg(yawDeg)}};
}

} // namespace

TEST(Newton, ConvergesQuadratically) {
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric()}) {
        const LegLengths lengths =
            legLengths(machine, {0.08 * Eigen::Vector3d(1, -1, 1) * machine.size(), {.3, -.2, .3}});
        double before = 1.0, order = 0.0;
        for (int k = 1; k <= 6; ++k) {
            const double now =
                NewtonRaphson(machine, {1e-15 * machine.size(), k}).solve(lengths, Pose{}).residual /
                machine.size();
            if (before < 1e-2 && now > 1e-13)
                order = std::log(now) / std::log(before);
            before = now;
        }
        EXPECT_GT(order, 1.7) << machine.name;
        EXPECT_LT(before, 1e-14) << machine.name;
    }
}

TEST(Newton, NeedsFewIterationsOnThePublishedSets) {
    const PlatformGeometry machine = laboratory();
    const NewtonRaphson newton(machine, {});
    const double most[] = {3.3, 4.4}; // on average, from home to 1e-10 m
    for (const int set : {1, 2}) {
        RandomPoses poses = publishedPoses(set, 41);
        int iterations = 0;
        for (int i = 0; i < 2000; ++i) {
            const Pose truth = poses.next();
            const ForwardResult result = newton.solve(legLengths(machine, truth), Pose{});
            iterations += result.iterations;
            ASSERT_EQ(result.status, SolveStatus::Converged);
            ASSERT_LT(distance(machine, result.pose, truth), 1e-8);
        }
        EXPECT_LT(iterations / 2000.0, most[set - 1]);
    }
}

TEST(Newton, AsPublishedTakesThePublishedIterations) {
    const PlatformGeometry machine = laboratory();
    const NewtonAsPublished newton(machine, {1e-3, 10});
    const double published[] = {26710, 41664};
    for (const int set : {1, 2}) {
        RandomPoses poses = publishedPoses(set, 42);
        int iterations = 0;
        PoseVector error = PoseVector::Zero();
        for (int i = 0; i < 10000; ++i) {
            const Pose truth = poses.next();
            const ForwardResult result = newton.solve(legLengths(machine, truth), Pose{});
            iterations += result.iterations;
            error += (result.pose.toVector() - truth.toVector()).cwiseAbs() / 10000;
        }
        EXPECT_NEAR(iterations / published[set - 1], 1.0, 0.03);
        PoseVector expected; // x y z alpha beta gamma, mean absolute errors of this iteration
        if (set == 1)
            expected << 4.1e-6, 3.7e-6, 1.8e-6, 3.1e-6, 2.0e-6, 1.8e-5;
        else
            expected << 4.4e-5, 4.9e-5, 3.1e-5, 3.2e-4, 1.2e-4, 5.9e-4;
        EXPECT_LT((error.cwiseQuotient(expected) - PoseVector::Ones()).cwiseAbs().maxCoeff(), 0.15);
    }
}

TEST(Newton, AsPublishedIsLinear) {
    const PlatformGeometry machine = laboratory();
    RandomPoses poses = publishedPoses(2, 43);
    int coarse = 0, fine = 0;
    const NewtonAsPublished toMillimetre(machine, {1e-3, 50}), toNanometre(machine, {1e-9, 50});
    for (int i = 0; i < 1000; ++i) {
        const LegLengths lengths = legLengths(machine, poses.next());
        coarse += toMillimetre.solve(lengths, Pose{}).iterations;
        fine += toNanometre.solve(lengths, Pose{}).iterations;
    }
    EXPECT_NEAR((fine - coarse) / 1000.0 / 6.0, 1.39, 0.07); // iterations a decade
}

TEST(Newton, SaysWhyThereIsNoPose) {
    const PlatformGeometry machine = laboratory();
    const NewtonRaphson newton(machine, {});
    // Two legs that differ by more than their joints are apart.
    EXPECT_EQ(statusOf(newton, metres(200, 500, 300, 300, 300, 300)), SolveStatus::NoSolution);
    EXPECT_EQ(newton.solve(metres(200, 500, 300, 300, 300, 300), Pose{}).iterations, 0);
    // No pair of legs contradicts, and yet no pose has these.
    EXPECT_EQ(statusOf(newton, metres(400, 320, 400, 320, 400, 320)), SolveStatus::NoSolution);
    // Beyond the fold, which lies at 343.07 and 256.76, home's branch has none; others end later.
    for (const double beyond : {1.0, 10.0, 40.0}) {
        const double longLeg = 343.07 + beyond, shortLeg = 256.76 - beyond;
        const LegLengths lengths = metres(longLeg, shortLeg, shortLeg, longLeg, shortLeg, shortLeg);
        const ForwardResult result = newton.solve(lengths, Pose{});
        EXPECT_EQ(result.status, beyond < 40.0 ? SolveStatus::OtherBranch : SolveStatus::NoSolution)
            << beyond;
        if (result.hasPose()) {
            EXPECT_LT((legLengths(machine, result.pose) - lengths).norm(), 1e-9);
        }
    }
    // So long that their products are no numbers.
    EXPECT_EQ(statusOf(newton, LegLengths::Constant(1e297)), SolveStatus::NoSolution);
    EXPECT_EQ(statusOf(newton, machine.homeLengths(), {{std::nan(""), 0, 0}, {}}), SolveStatus::InvalidInput);
}

TEST(Newton, LengthsOfAPoseAreNeverSaidToHaveNone) {
    for (const PlatformGeometry& machine : {laboratory(), asymmetric(), octahedral()}) {
        const NewtonRaphson newton(machine, {});
        RandomPoses poses(0.4 * machine.size(), radiansFromDeg(110.0), 47);
        for (int i = 0; i < testing_support::samples(2000); ++i)
            ASSERT_NE(statusOf(newton, legLengths(machine, poses.next())), SolveStatus::NoSolution)
                << machine.name << ", pose " << i;
    }
}

TEST(Newton, IsNotDeceivedByLegsFarFromTheirTargets) {
    // The step's right-hand side is a series that vanishes where a leg is 5^(1/2) times its target, too.
    const PlatformGeometry machine = laboratory();
    const Pose start{{0.012, -0.004, 0.040}, {0.0, 0.0, radiansFromDeg(5.0)}};
    for (int leg = -1; leg < kLegCount; ++leg) {
        LegLengths lengths = legLengths(machine, start);
        for (int i = 0; i < kLegCount; ++i)
            lengths[i] /= leg == -1 || leg == i ? std::sqrt(5.0) : 1.0;
        for (const double tolerance : {1e-10, 1e-5, 5e-4}) {
            const ForwardResult result = NewtonRaphson(machine, {tolerance, 50}).solve(lengths, start);
            if (leg == -1 && result.isUsable()) { // a smaller machine's pose, but a true one
                EXPECT_LE((legLengths(machine, result.pose) - lengths).norm(), 1.001 * tolerance);
            } else {
                EXPECT_FALSE(result.isUsable() || result.accurate) << leg << " " << toWord(result.status);
            }
        }
    }
}

TEST(Newton, TellsTheResidualAlsoWhenItIsLarge) {
    const PlatformGeometry machine = laboratory();
    RandomPoses poses(0.06, radiansFromDeg(60.0), 48);
    for (const double tolerance : {1e-6, 1e-4, 1e-3, 1e-2, 0.05}) {
        const NewtonRaphson newton(machine, {tolerance, 50});
        for (int i = 0; i < testing_support::samples(2000); ++i) {
            const LegLengths lengths = legLengths(machine, poses.next());
            const ForwardResult result = newton.solve(lengths, i % 2 == 0 ? Pose{} : poses.next());
            if (!result.hasPose())
                continue;
            const double residual = (legLengths(machine, result.pose) - lengths).norm();
            EXPECT_NEAR(result.residual, residual, 2e-4 * residual + 1e-15);
            EXPECT_EQ(result.accurate, residual <= tolerance);
        }
    }
}

TEST(Newton, TakesNoStepWhereNoneIsAllowed) {
    const PlatformGeometry machine = laboratory();
    const NewtonRaphson none(machine, {1e-3, 0});
    const LegLengths lengths = legLengths(machine, Pose{{0.001, 0.0, 0.001}, {}});
    for (const Pose& start : {Pose{}, Pose{{1e-9, 0.0, 0.0}, {}}}) {
        EXPECT_EQ(none.solve(lengths, start).status, SolveStatus::IterationLimit);
        EXPECT_EQ(none.solve(lengths, start).iterations, 0);
    }
}

TEST(Newton, SaysSingular) {
    const PlatformGeometry hexagons = similarHexagons();
    RandomPoses poses(0.02, 0.2, 44);
    for (int i = 0; i < 20; ++i) {
        const LegLengths lengths = i == 0 ? hexagons.homeLengths() : legLengths(hexagons, poses.next());
        EXPECT_EQ(statusOf(NewtonRaphson(hexagons, {}), lengths), SolveStatus::Singular);
        EXPECT_EQ(statusOf(NewtonAsPublished(hexagons, {}), lengths), SolveStatus::Singular);
    }
    const PlatformGeometry machine = laboratory(); // a quarter turn of a level platform
    const NewtonRaphson newton(machine, {});
    EXPECT_EQ(statusOf(newton, legLengths(machine, level(0.0, 90.0)), level(0.0, 90.0)),
              SolveStatus::Singular);
    EXPECT_EQ(statusOf(newton, legLengths(machine, level(0.0, 90.0)), level(0.0, 80.0)),
              SolveStatus::Singular);
}

TEST(Newton, SaysOtherBranch) {
    const PlatformGeometry machine = laboratory();
    for (const double yaw : {100.0, 120.0, -110.0}) {
        const Pose beyond = level(0.01, yaw);
        ASSERT_LT(singularityMeasure(machine, beyond).determinant, 0.0);
        const ForwardResult result = NewtonRaphson(machine, {}).solve(legLengths(machine, beyond), beyond);
        EXPECT_EQ(result.status, SolveStatus::OtherBranch);
        EXPECT_TRUE(result.accurate && !result.isUsable());
        EXPECT_LT(distance(machine, result.pose, beyond), 1e-9);
    }
}

TEST(Newton, StopsAtTheIterationLimit) {
    const PlatformGeometry machine = laboratory();
    const LegLengths lengths = legLengths(machine, {{0.03, -0.02, 0.035}, {0.4, -0.3, 0.5}});
    const ForwardResult exact = NewtonRaphson(machine, {0.0, 2}).solve(lengths, Pose{});
    EXPECT_EQ(exact.status, SolveStatus::IterationLimit);
    EXPECT_EQ(exact.iterations, 2);
    EXPECT_FALSE(exact.accurate || exact.isUsable());
    EXPECT_EQ(statusOf(NewtonAsPublished(machine, {0.0, 3}), lengths), SolveStatus::IterationLimit);
    EXPECT_EQ(statusOf(NewtonRaphson(machine, {0.0, 0}), lengths), SolveStatus::IterationLimit);
}

TEST(Newton, IsTheSameForAMachineInMicrometresAndInKilometres) {
    const PlatformGeometry machine = laboratory();
    for (const double factor : {1e-6, 1e-3, 1e3, 1e6}) {
        const PlatformGeometry other = scaledBy(factor, machine);
        const NewtonRaphson first(machine, {}), second(other, {});
        EXPECT_NEAR(defaultTolerance(other) / factor, 1e-10, 1e-15);
        RandomPoses poses(0.08, radiansFromDeg(75.0), 46); // some of them without a solution on this side
        for (int i = 0; i < 300; ++i) {
            const LegLengths lengths = legLengths(machine, poses.next());
            const ForwardResult a = first.solve(lengths, Pose{});
            const ForwardResult b = second.solve(factor * lengths, Pose{});
            ASSERT_EQ(toWord(a.status), toWord(b.status));
            if (a.status != SolveStatus::Converged)
                continue;
            EXPECT_NEAR(a.iterations, b.iterations, 1);
            const Pose backScaled{b.pose.offset / factor, b.pose.angles};
            EXPECT_LT(distance(machine, a.pose, backScaled), 1e-5);
        }
    }
}

TEST(Newton, CrossesGimbalLock) {
    PlatformGeometry machine = octahedral();
    machine.p_OP_home_B
        .setZero(); // the same machine, with its axes turned so that home is pitched by 90 degrees
    const Eigen::Matrix3d turn = rotationMatrix({0.0, std::numbers::pi / 2, 0.0});
    for (Leg& leg : machine.legs)
        leg.p_OA_B -= Eigen::Vector3d(0.0, 0.0, 0.9);
    for (Leg& leg : machine.legs)
        leg.p_PB_P = turn.transpose() * leg.p_PB_P;
    const Pose start{Eigen::Vector3d::Zero(), {0.0, std::numbers::pi / 2 - 0.05, 0.0}};
    const Pose truth{{0.02, 0.01, -0.03}, {0.02, std::numbers::pi / 2, 0.01}};
    const LegLengths lengths = legLengths(machine, truth);
    const ForwardResult result = NewtonRaphson(machine, {}).solve(lengths, start);
    EXPECT_TRUE(result.accurate);
    EXPECT_LT(result.iterations, 8);
    EXPECT_LT((legLengths(machine, result.pose) - lengths).norm(), 1e-9);
}

TEST(SolveStatus, HasOneWordEach) {
    for (const char* word : {"converged", "iteration-limit", "singular", "no-solution", "invalid-input",
                             "outside-model", "other-branch"}) {
        ASSERT_TRUE(solveStatusFromWord(word).has_value()) << word;
        EXPECT_EQ(toWord(*solveStatusFromWord(word)), word);
    }
    EXPECT_FALSE(solveStatusFromWord("ok").has_value());
}
