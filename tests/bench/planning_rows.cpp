// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "planning_rows.h"

#include "core/base/units.h"
#include "core/kinematics/platform_model.h"
#include "core/kinematics/pose_samples.h"
#include "core/motion/motion_planner.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cstdio>
#include <string>

namespace hexapose::bench {

namespace {

constexpr double kSlack = 2e-4; ///< m

Pose poseMm(double x, double y, double z, double alpha, double beta, double gamma) {
    return {{metresFromMm(x), metresFromMm(y), metresFromMm(z)},
            {radiansFromDeg(alpha), radiansFromDeg(beta), radiansFromDeg(gamma)}};
}

/// Strokes of 45 % of the legs about home: wide enough to come near to singular poses.
PlatformGeometry withWideStrokes(PlatformGeometry machine) {
    const LegLengths home = machine.homeLengths();
    for (std::size_t i = 0; i < kLegCount; ++i) {
        machine.legs[i].minLength = 0.55 * home[static_cast<int>(i)];
        machine.legs[i].maxLength = 1.45 * home[static_cast<int>(i)];
    }
    return machine;
}

/// Legs of 6 mm, and P 100 mm below its joints.
PlatformGeometry withFarOrigin(PlatformGeometry machine) {
    constexpr double kScale = 0.02, kBelow = 0.1;
    machine.p_OP_home_B = kScale * machine.p_OP_home_B - kBelow * Eigen::Vector3d::UnitZ();
    for (Leg& leg : machine.legs) {
        leg.p_OA_B *= kScale;
        leg.p_PB_P = kScale * leg.p_PB_P + kBelow * Eigen::Vector3d::UnitZ();
        leg.minLength = 0.005;
        leg.maxLength = 0.007;
    }
    return machine;
}

void addPlan(const std::string& name, const PlatformGeometry& machine, const Pose& from,
             const StraightMove& move) {
    const SharedModel model = makeModel(machine);
    const MotionBounds bounds = withDefaults(MotionBounds{}, machine);
    MotionLimits limits = motionLimits(machine, std::nullopt, std::nullopt);
    limits.legSpeed = bounds.legSpeed;
    limits.legAcceleration = bounds.legAcceleration;
    benchmark::RegisterBenchmark(("plan, " + name).c_str(), [=](benchmark::State& state) {
        const PlanStart start{model->actuators(from), from};
        for (auto _ : state) {
            const PlannedMotion planned = planMotion(*model, bounds, limits, kSlack, start, move);
            if (!planned.check.ok())
                state.SkipWithError("refused");
        }
    });
}

} // namespace

void addPlanning(const PlatformGeometry& laboratory) {
    benchmark::RegisterBenchmark("how near to singular", [model = makeModel(laboratory)](
                                                             benchmark::State& state) {
        PoseSamples samples(0.04, radiansFromDeg(20.0), 5, 0);
        std::array<Pose, 256> poses;
        for (Pose& pose : poses)
            pose = samples.next();
        std::size_t next = 0;
        for (auto _ : state)
            benchmark::DoNotOptimize(model->singularity(poses[next++ % poses.size()]).smallestSingularValue);
    });
    benchmark::RegisterBenchmark("how near to singular, at home",
                                 [model = makeModel(laboratory)](benchmark::State& state) {
                                     for (auto _ : state)
                                         benchmark::DoNotOptimize(model->singularity(Pose{}).condition);
                                 });
    benchmark::RegisterBenchmark("making a PlatformModel", [laboratory](benchmark::State& state) {
        for (auto _ : state)
            benchmark::DoNotOptimize(PlatformModel(laboratory).homeDeterminant());
    });
    const Pose from = poseMm(-10, 5, -12, 4, -3, 2), to = poseMm(12, -4, 20, -3, 4, 6);
    addPlan("joint", laboratory, from, {to, MotionMode::Joint});
    addPlan("workspace", laboratory, from, {to, MotionMode::Workspace});
    addPlan("joint, near the margin", withWideStrokes(laboratory),
            poseMm(-64.0489675, -19.6652436, -13.3603402, -60.7465414, -58.5573279, -16.3378257),
            {poseMm(-30.310653, -101.987168, 30.1891191, -60.6441724, -31.6973457, -52.1687385),
             MotionMode::Joint});
    addPlan("workspace, P far from its joints", withFarOrigin(laboratory), Pose{},
            {poseMm(2.095104966, 13.74473256, 1.362742007, 8.007710774, 0.3186091354, -11.34268807),
             MotionMode::Workspace});
}

} // namespace hexapose::bench
