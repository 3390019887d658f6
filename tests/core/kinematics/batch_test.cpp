// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Many solutions at once are those of the single solver, in every lane and for every length of the array.
#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/vector/newton_lanes.h"
#include "test_machines.h"
#include "tests/support/sample_count.h"
#include "tests/support/vector_unit.h"

#include <gtest/gtest.h>

#include <limits>

namespace hexapose::testing {
namespace {

using testing_support::OnlyVectorUnit;
using testing_support::samples;

constexpr double kSame = 1e-12; ///< machine sizes and radians

void expectSame(const PlatformGeometry& machine, const ForwardResult& a, const ForwardResult& b,
                std::size_t row) {
    ASSERT_EQ(a.status, b.status) << machine.name << " row " << row;
    ASSERT_EQ(a.accurate, b.accurate);
    if (!a.hasPose())
        return;
    ASSERT_LT((a.pose.offset - b.pose.offset).norm() / machine.size(), kSame)
        << machine.name << " row " << row;
    ASSERT_LT((a.pose.toVector() - b.pose.toVector()).tail<3>().norm(), kSame)
        << machine.name << " row " << row;
    ASSERT_EQ(a.iterations, b.iterations);
}

std::vector<ForwardResult> solveAll(const NewtonRaphson& newton, const std::vector<LegLengths>& lengths,
                                    unsigned threads = 1) {
    std::vector<ForwardResult> results(lengths.size());
    newton.solveAll(lengths, results, threads);
    return results;
}

std::vector<LegLengths> ordinary(const PlatformGeometry& machine, int count, std::uint64_t seed) {
    RandomPoses poses(0.1 * machine.size(), radiansFromDeg(30.0), seed);
    std::vector<LegLengths> lengths;
    for (int i = 0; i < count; ++i)
        lengths.push_back(legLengths(machine, poses.next()));
    return lengths;
}

} // namespace

TEST(Batch, IsTheSingleSolverInEveryLaneAndForEveryRemainder) {
    const auto lanes = static_cast<int>(laneCount());
    ASSERT_GE(lanes, 1);
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric(),
                                            scaledBy(1e-3, laboratory()), scaledBy(1e6, asymmetric())}) {
        const NewtonRaphson newton(machine, {});
        for (int count = 0; count <= 3 * lanes; ++count) {
            const auto lengths = ordinary(machine, count, static_cast<std::uint64_t>(count) + 5);
            const auto results = solveAll(newton, lengths);
            for (std::size_t i = 0; i < lengths.size(); ++i)
                expectSame(machine, results[i], newton.solve(lengths[i], Pose{}), i);
        }
    }
}

TEST(Batch, IsTheSameOnEveryVectorUnit) {
    constexpr int kPoses = 203; // many groups, and a remainder for every number of lanes
    for (const PlatformGeometry& machine : {laboratory(), asymmetric(), scaledBy(1e-3, octahedral())}) {
        const NewtonRaphson newton(machine, {});
        const auto lengths = ordinary(machine, kPoses, 17);
        const auto best = solveAll(newton, lengths);
        for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
            SCOPED_TRACE(hwy::TargetName(target));
            const OnlyVectorUnit only(target);
            const auto results = solveAll(newton, lengths);
            for (std::size_t i = 0; i < lengths.size(); ++i) {
                expectSame(machine, results[i], newton.solve(lengths[i], Pose{}), i);
                expectSame(machine, results[i], best[i], i);
            }
        }
    }
}

TEST(Batch, ABadRowIsItsOwnMatterInEveryLane) {
    const PlatformGeometry machine = laboratory();
    const NewtonRaphson newton(machine, {});
    const std::size_t lanes = laneCount();
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                     kInf = std::numeric_limits<double>::infinity();
    for (const double bad : {kNan, kInf, -0.3, 0.0, 1e300, 1e-300, 5.0})
        for (std::size_t place = 0; place < 2 * lanes + 1; ++place) {
            auto lengths = ordinary(machine, static_cast<int>(2 * lanes + 1), 9);
            lengths[place][static_cast<Eigen::Index>(place % 6)] = bad;
            const auto results = solveAll(newton, lengths);
            for (std::size_t i = 0; i < lengths.size(); ++i)
                expectSame(machine, results[i], newton.solve(lengths[i], Pose{}), i);
            EXPECT_FALSE(results[place].isUsable());
        }
}

TEST(Batch, WidePosesTooAndOnSeveralThreads) {
    const PlatformGeometry machine = laboratory();
    const NewtonRaphson newton(machine, {});
    RandomPoses poses(0.08, radiansFromDeg(75.0), 3);
    std::vector<LegLengths> lengths;
    for (int i = 0; i < samples(5000) + 3; ++i)
        lengths.push_back(legLengths(machine, poses.next()));
    const auto one = solveAll(newton, lengths), several = solveAll(newton, lengths, 3);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        expectSame(machine, one[i], newton.solve(lengths[i], Pose{}), i);
        expectSame(machine, one[i], several[i], i);
    }
}

TEST(Batch, ASingularMachineSaysSoInEveryRow) {
    const PlatformGeometry machine = similarHexagons();
    const auto lengths = ordinary(machine, 11, 2);
    for (const ForwardResult& result : solveAll(NewtonRaphson(machine, {}), lengths))
        EXPECT_EQ(result.status, SolveStatus::Singular);
}

} // namespace hexapose::testing
