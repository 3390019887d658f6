// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Where paths of the laboratory platform go, and where they stop: clean, near a singular pose, into a fold,
// across.
#include "core/kinematics/newton/home_side.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/singularity.h"
#include "tests/core/finite_step/finite_step_fixture.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <numbers>

namespace hexapose::testing::path_test {
namespace {

constexpr StepForm kForms[] = {StepForm::Open, StepForm::Closed, StepForm::Corrected};

std::vector<LegLengths> tableOf(const PlatformGeometry& machine, int steps,
                                const std::function<Pose(double)>& poseAt) {
    std::vector<LegLengths> table;
    for (int k = 1; k <= steps; ++k)
        table.push_back(legLengths(machine, poseAt(static_cast<double>(k) / steps)));
    return table;
}

TEST(LegPath, HomeIsWhatThePrototypeFound) {
    const SingularityMeasure home = singularityMeasure(laboratoryAtJoints(), Pose{});
    EXPECT_NEAR(std::abs(home.determinant), 2.677613, 5e-7);
    EXPECT_NEAR(home.smallestSingularValue, 0.69462, 5e-6);
    EXPECT_NEAR(home.condition, 3.2087, 5e-5);
}

TEST(LegPath, AtLevelPosesTheRatioIsTheClosedForm) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const HexapodSteps steps{PlatformModel(machine)};
    const auto oracle = [&](const Pose& pose) {
        const double height = 272.9 + mmFromMetres(pose.offset[2]);
        const double lengths = legLengths(machine, pose).unaryExpr(&mmFromMetres).prod();
        return 9.588254911e7 * std::pow(height, 3) * std::cos(pose.angles.gamma) / lengths;
    };
    for (const Pose& pose :
         {poseMmDeg(0, 0, 30, 0, 0, 40), poseMmDeg(-50, 20, -40, 0, 0, -70), poseMmDeg(10, 0, 0, 0, 0, 100)})
        EXPECT_NEAR(steps.determinantRatio(steps.marksAt(pose)), oracle(pose) / oracle(Pose{}), 1e-9);
    EXPECT_NEAR(steps.determinantRatio(steps.marksAt(poseMmDeg(0, 0, 0, 0, 0, 90))), 0.0, 1e-12);
}

TEST(LegPath, AIsClean) {
    const PlatformGeometry machine = laboratoryAtJoints();
    for (const StepForm form : kForms) {
        const PathResult result =
            LegPath(machine).followStraight(Pose{}, legLengths(machine, kTarget2), 1000, form);
        EXPECT_EQ(result.end, PathEnd::Reached);
        EXPECT_EQ(result.step, 1000);
        EXPECT_NEAR(result.q, 0.537, 1e-3);
        EXPECT_NEAR(result.leastQ, result.q, 1e-12);
        EXPECT_NEAR(result.smallestSingularValue, singularityMeasure(machine, kTarget2).smallestSingularValue,
                    1e-3);
    }
}

TEST(LegPath, BPassesNearASingularPoseAndComesBack) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const auto near = [](double t) {
        return Pose::fromVector(std::sin(std::numbers::pi * t) *
                                poseMmDeg(15, -10, 20, 5, -4, 84).toVector());
    };
    const auto table = tableOf(machine, 1000, near);
    const PathResult result = LegPath(machine).followTable(Pose{}, table, StepForm::Closed);
    EXPECT_EQ(result.end, PathEnd::Reached);
    EXPECT_NEAR(result.leastQ, 0.0436, 2e-4);
    EXPECT_NEAR(result.q, 1.0, 1e-3);
    EXPECT_NEAR(errorOf(machine, result.pose, Pose{}).mm / 5.4e-4, 1.0, 0.05);
    EXPECT_EQ(LegPath(machine).followTable(Pose{}, table, StepForm::Corrected).end, PathEnd::Reached);
}

TEST(LegPath, CStopsBeforeTheFold) {
    constexpr double kFold = 0.9518;
    const PlatformGeometry machine = laboratoryAtJoints();
    const LegLengths target = metres(400, 320, 400, 320, 400, 320);
    for (const StepForm form : kForms)
        for (const int steps : {30, 100, 300, 1000, 3000}) {
            const PathResult result = LegPath(machine).followStraight(Pose{}, target, steps, form);
            EXPECT_EQ(result.end, PathEnd::Singular);
            const double stopped = static_cast<double>(result.step) / steps;
            EXPECT_LT(stopped, kFold + (steps > 300 ? 5e-4 : 0.0)) << steps;
            EXPECT_GT(stopped, 0.8 * kFold) << steps;
            EXPECT_GT(result.q, 0.0);
            EXPECT_LT(result.smallestSingularValue, 0.4);
            ASSERT_TRUE(result.pose.isFinite());
            // It has not bounced off: the pose is still that of the legs where it stopped.
            const LegLengths home = machine.homeLengths();
            const LegLengths there = home + stopped * (target - home);
            const double tolerance = form == StepForm::Open ? 3.0 / steps : 0.5 / steps;
            EXPECT_LT((legLengths(machine, result.pose) - there).norm(), tolerance) << steps;
        }
}

TEST(LegPath, DStopsBeforeTheCrossing) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const auto turn = [](double t) { return poseMmDeg(0, 0, 0, 0, 0, 120.0 * t); };
    for (const StepForm form : kForms)
        for (const int steps : {300, 1000, 3000}) {
            const auto table = tableOf(machine, steps, turn);
            const PathResult result = LegPath(machine).followTable(Pose{}, table, form);
            EXPECT_EQ(result.end, PathEnd::Singular);
            const double stopped = static_cast<double>(result.step) / steps;
            EXPECT_GT(stopped, 0.69) << steps;
            EXPECT_LT(stopped, 0.75) << steps;
        }
    // Nothing else tells: the twin pose has the same legs, to the last digit, and is as far from singular.
    const Pose twin = NewtonRaphson(machine, {}).solve(legLengths(machine, turn(1.0)), Pose{}).pose;
    EXPECT_NEAR(degFromRadians(twin.angles.gamma), 60.0, 0.5);
    EXPECT_NEAR(mmFromMetres(twin.offset[2]), 52.8, 0.1);
}

/// How far the legs can go straight to a target, by Newton's iteration in steps of its own choice, which
/// shares nothing with the stop rule; 1 where there is no fold.
double foldOf(const LegEquations& equations, const HomeSide& side, const LegLengths& home,
              const LegLengths& target) {
    const auto reaches = [&](double part) {
        int iterations = 0;
        return side
            .follow(equations.placementOf(Pose{}), equations.scaled(home + part * (target - home)), 1e-9,
                    iterations)
            .has_value();
    };
    if (reaches(1.0))
        return 1.0;
    double low = 0.0, high = 1.0;
    while (high - low > 1e-4)
        (reaches(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    return low;
}

TEST(LegPath, StopsAtEveryFoldAndSeldomElsewhere) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const LegPath path(machine);
    const LegEquations equations(machine);
    const HomeSide side(equations, PlatformModel(machine).homeDeterminant());
    const LegLengths home = machine.homeLengths();
    int folds = 0, clean = 0;
    std::array<int, 3> alarms{};
    for (std::uint64_t seed = 1000; seed < 1200; ++seed) {
        RandomPoses spread(1.0, 1.0, seed);
        const LegLengths target = home + 0.09 * spread.next().toVector();
        const double fold = foldOf(equations, side, home, target);
        (fold == 1.0 ? clean : folds)++;
        std::size_t which = 0;
        for (const int steps : {30, 300, 3000}) {
            const PathResult result = path.followStraight(Pose{}, target, steps, StepForm::Closed);
            const bool stopped = result.end == PathEnd::Singular;
            if (fold == 1.0)
                alarms[which] += stopped ? 1 : 0;
            else
                EXPECT_TRUE(stopped && static_cast<double>(result.step) / steps < fold + 1e-3)
                    << seed << ", " << steps << " steps, fold " << fold << ", at " << result.step;
            ++which;
        }
    }
    EXPECT_GT(folds, 20);
    EXPECT_GT(clean, 50);
    EXPECT_LE(alarms[0], clean / 5);
    EXPECT_LE(alarms[1], clean / 50);
    EXPECT_EQ(alarms[2], 0);
}

TEST(LegPath, GoesOutAndBack) {
    const PlatformGeometry machine = laboratoryAtJoints();
    for (const StepForm form : kForms) {
        const LegPath path(machine);
        const PathResult out = path.followStraight(Pose{}, legLengths(machine, kTarget2), 400, form);
        const PathResult back = path.followStraight(out.pose, machine.homeLengths(), 400, form);
        ASSERT_EQ(back.end, PathEnd::Reached);
        const double allowed = form == StepForm::Open ? 0.2 : form == StepForm::Closed ? 1e-3 : 1e-8;
        EXPECT_LT(errorOf(machine, back.pose, Pose{}).mm, allowed);
    }
}

TEST(LegPath, RefusesWhatIsNoPath) {
    const PlatformGeometry machine = laboratory();
    const LegPath path(machine);
    LegLengths bad = machine.homeLengths();
    bad[3] = std::nan("");
    const Pose nowhere{Eigen::Vector3d::Constant(std::nan("")), {}};
    for (const PathResult& result : {path.followStraight(Pose{}, bad, 10, StepForm::Open),
                                     path.followStraight(nowhere, machine.homeLengths(), 10, StepForm::Open),
                                     path.followStraight(Pose{}, machine.homeLengths(), 0, StepForm::Open),
                                     path.followTable(Pose{}, {}, StepForm::Open)}) {
        EXPECT_EQ(result.end, PathEnd::InvalidInput);
        EXPECT_FALSE(result.pose.isFinite());
    }
    const PathResult still = path.followStraight(Pose{}, machine.homeLengths(), 1, StepForm::Open);
    EXPECT_EQ(still.end, PathEnd::Reached);
    EXPECT_LT(still.pose.toVector().norm(), 1e-12);
    EXPECT_EQ(LegPath(similarHexagons())
                  .followStraight(Pose{}, 1.01 * similarHexagons().homeLengths(), 10, StepForm::Closed)
                  .end,
              PathEnd::Singular)
        << "singular at home";
}

} // namespace
} // namespace hexapose::testing::path_test
