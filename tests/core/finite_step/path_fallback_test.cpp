// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// MPR-NR that follows the path from a known pose where it is not sure of its branch.
#include "core/finite_step/path_fallback.h"
#include "core/kinematics/regression/mpr_newton.h"
#include "core/kinematics/singularity.h"
#include "tests/core/finite_step/finite_step_fixture.h"
#include "tests/support/sample_count.h"

#include <gtest/gtest.h>

namespace hexapose::testing::path_fallback_test {
namespace {

using testing_support::samples;

/// Says what it is told to.
class Parrot final : public ForwardSolver {
public:
    explicit Parrot(const ForwardResult& words) : m_words(words) {}
    ForwardResult solve(const LegLengths&, const Pose&) const noexcept override { return m_words; }
    std::string_view name() const noexcept override { return "parrot"; }

private:
    ForwardResult m_words;
};

PathFallback fallbackFrom(const PlatformGeometry& machine, SolveStatus status,
                          const PathFallbackOptions& options = {}) {
    return {machine, std::make_shared<Parrot>(ForwardResult{poseMmDeg(1, 2, 3, 4, 5, 6), status, 7, 0.5}),
            options};
}

std::shared_ptr<const MprNewton> mprNewton(const PlatformGeometry& machine) {
    TrainingSpec spec = defaultTrainingSpec(machine, 3);
    spec.samples = 4000;
    return std::make_shared<MprNewton>(machine, *trainModel(machine, spec), NewtonOptions{});
}

TEST(PathFallback, FollowsThePathWhereTheSolverIsNotSure) {
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric(),
                                            scaledBy(1e-3, laboratory()), scaledBy(1e6, laboratory())}) {
        SCOPED_TRACE(machine.name);
        RandomPoses poses(0.06 * machine.size(), radiansFromDeg(10.0), 35);
        for (const SolveStatus status :
             {SolveStatus::OtherBranch, SolveStatus::Singular, SolveStatus::IterationLimit}) {
            const Pose truth = poses.next(), start = poses.next();
            const auto answer = fallbackFrom(machine, status).answer(legLengths(machine, truth), start);
            EXPECT_TRUE(answer.fromPath);
            ASSERT_TRUE(answer.path && answer.path->step == 1000);
            ASSERT_EQ(answer.result.status, SolveStatus::Converged);
            EXPECT_TRUE(answer.result.accurate);
            EXPECT_GE(answer.result.iterations, 1007);
            EXPECT_LE(answer.result.residual, defaultTolerance(machine));
            EXPECT_LT(distance(machine, answer.result.pose, truth), 1e-9);
        }
    }
}

TEST(PathFallback, LeavesAloneWhatIsSure) {
    const PlatformGeometry machine = laboratory();
    for (const SolveStatus status : {SolveStatus::NoSolution, SolveStatus::InvalidInput}) {
        const auto answer = fallbackFrom(machine, status).answer(machine.homeLengths(), Pose{});
        EXPECT_FALSE(answer.path || answer.fromPath);
        EXPECT_EQ(answer.result.status, status);
    }
    const auto limited = fallbackFrom(machine, SolveStatus::IterationLimit, {.afterIterationLimit = false});
    EXPECT_EQ(limited.solve(machine.homeLengths(), Pose{}).status, SolveStatus::IterationLimit);
    EXPECT_EQ(limited.name(), "parrot");
}

TEST(PathFallback, SaysNothingMoreBehindAFold) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const auto answer =
        fallbackFrom(machine, SolveStatus::OtherBranch).answer(metres(400, 320, 400, 320, 400, 320), Pose{});
    EXPECT_FALSE(answer.fromPath || answer.result.isUsable());
    EXPECT_EQ(answer.result.status, SolveStatus::OtherBranch) << "the solver's word stands";
    EXPECT_EQ(answer.result.iterations, 7);
    ASSERT_TRUE(answer.path);
    EXPECT_EQ(answer.path->end, PathEnd::Singular);
    EXPECT_GT(answer.path->step, 900);
    EXPECT_LT(answer.path->step, 960);
}

/// Legs that lead across a singular pose, yaw 90 deg, a degree at a time; and a start behind it.
TEST(PathFallback, FollowsNoPathAcrossASingularPose) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const PathFallback solver = fallbackFrom(machine, SolveStatus::OtherBranch);
    const auto yaw = [](double deg) { return poseMmDeg(0, 0, 0, 0, 0, deg); };
    Pose start;
    int reached = 0;
    for (ForwardResult result; reached < 120; ++reached, start = result.pose) {
        result = solver.solve(legLengths(machine, yaw(reached + 1)), start);
        if (!result.isUsable())
            break;
        EXPECT_LT(distance(machine, result.pose, yaw(reached + 1)), 1e-9);
    }
    EXPECT_GT(reached, 85);
    EXPECT_LT(reached, 90);
    const auto behind = solver.answer(legLengths(machine, yaw(110)), yaw(100));
    EXPECT_EQ(behind.result.status, SolveStatus::OtherBranch);
    EXPECT_EQ(behind.path->step, 0);
}

double determinantRatio(const PlatformGeometry& machine, const Pose& pose) {
    return singularityMeasure(machine, pose).determinant / singularityMeasure(machine, Pose{}).determinant;
}

struct Count {
    int right = 0, other = 0, followed = 0;
};

/// Poses on home's side, each from a start nearby on the same side. `other`: usable, and not the pose.
constexpr int kPoses = 4000;

struct Sample {
    double mm, deg;
    Count bare, whole;
};
Sample take(const PlatformGeometry& machine, const PathFallback& whole, const MprNewton& bare, double mm,
            double deg, double nearMm) {
    const double scale = machine.size() / laboratory().size();
    RandomPoses poses(metresFromMm(mm) * scale, radiansFromDeg(deg), 20230382);
    RandomPoses steps(metresFromMm(nearMm) * scale, radiansFromDeg(nearMm), 77);
    Sample sample{mm, deg, {}, {}};
    for (int i = 0; i < samples(kPoses); ++i) {
        const Pose truth = poses.next();
        const Pose near = Pose::fromVector(truth.toVector() + steps.next().toVector());
        const Pose start = nearMm > 0.0 ? near : Pose{};
        if (!(determinantRatio(machine, truth) > 0.0 && determinantRatio(machine, start) > 0.0))
            continue;
        const auto note = [&](const ForwardResult& result, Count& count) {
            const bool right = distance(machine, result.pose, truth) < 1e-6;
            count.right += result.isUsable() && right;
            count.other += result.isUsable() && !right;
        };
        const LegLengths lengths = legLengths(machine, truth);
        const auto answer = whole.answer(lengths, start);
        note(bare.solve(lengths, start), sample.bare);
        note(answer.result, sample.whole);
        sample.whole.followed += answer.fromPath;
    }
    return sample;
}

TEST(PathFallback, WidePosesAreConnectedToANearStartOrSaySo) {
    int others = 0, followed = 0;
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric()}) {
        SCOPED_TRACE(machine.name);
        const auto bare = mprNewton(machine);
        const PathFallback whole(machine, bare);
        for (const double nearMm : {0.2, 2.0})
            for (const auto& [mm, deg] : {std::pair{60.0, 60.0}, std::pair{80.0, 75.0}}) {
                const Sample sample = take(machine, whole, *bare, mm, deg, nearMm);
                EXPECT_EQ(sample.whole.other, 0) << mm;
                EXPECT_GE(sample.whole.right, sample.bare.right) << mm;
                others += sample.bare.other;
                followed += sample.whole.followed;
            }
    }
    if (samples(kPoses) < kPoses) // so few of them may hold none
        return;
    EXPECT_GT(others, 0) << "the regression leads astray here, or nothing was tried";
    EXPECT_GT(followed, 0);
}

TEST(PathFallback, FromHomeNoRightPoseIsLost) {
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric()}) {
        SCOPED_TRACE(machine.name);
        const auto bare = mprNewton(machine);
        const PathFallback whole(machine, bare);
        for (const auto& [mm, deg] : {std::pair{60.0, 60.0}, std::pair{80.0, 75.0}}) {
            const Sample sample = take(machine, whole, *bare, mm, deg, 0.0);
            EXPECT_GE(sample.whole.right, sample.bare.right) << mm;
            EXPECT_LE(sample.whole.other, sample.bare.other) << mm;
        }
    }
}

TEST(PathFallback, OnlyMprNewtonGetsOne) {
    const PlatformGeometry machine = laboratory();
    const auto solver = std::make_shared<NewtonRaphson>(machine, NewtonOptions{});
    for (const ForwardMethod& method : forwardMethods()) {
        const bool mprNewton = method.word == "mpr2-nr" || method.word == "mpr3-nr";
        EXPECT_EQ(withPathFallback(method, makeModel(machine), solver) == solver, !mprNewton) << method.word;
    }
}

} // namespace
} // namespace hexapose::testing::path_fallback_test
