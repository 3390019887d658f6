// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/axis_range.h"

#include "tests/ui/console/synthetic_machine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hexapose {
namespace {

using namespace hexapose::testing;

constexpr double kRangeResolution = 2e-4; // m or rad, of the bisection

MotionPlanner plannerWithin(double furthestMetres) {
    ControlOptions options;
    options.envelope.furthest.head<3>().setConstant(furthestMetres);
    const SharedModel model = makeModel(laboratoryPlatform());
    return {model, plannerSettings(options, model->geometry())};
}

Pose alongAxis(int axis, double value) {
    PoseVector at = PoseVector::Zero();
    at[axis] = value;
    return Pose::fromVector(at);
}

TEST(AxisRange, EndsWhereTheFirstLimitIsMet) {
    const MotionPlanner planner = plannerWithin(std::numeric_limits<double>::infinity());
    for (int axis = 0; axis < 6; ++axis) {
        const auto range = axisRange(planner, Pose{}, axis);
        ASSERT_TRUE(range);
        for (const double end : {range->first, range->second}) {
            EXPECT_TRUE(planner.check(alongAxis(axis, end)).ok()) << axis;
            const double beyond = end + std::copysign(kRangeResolution, end);
            EXPECT_FALSE(planner.check(alongAxis(axis, beyond)).ok()) << axis;
        }
    }
    EXPECT_FALSE(axisRange(planner, poseOf(0, 0, 300, 0, 0, 0), 0));
}

TEST(AxisRange, EndsAtTheEnvelope) {
    constexpr double kFurthest = 0.005;
    const MotionPlanner planner = plannerWithin(kFurthest);
    for (int axis = 0; axis < 3; ++axis) {
        const auto range = axisRange(planner, Pose{}, axis);
        ASSERT_TRUE(range);
        EXPECT_NEAR(range->first, -kFurthest, kRangeResolution) << axis;
        EXPECT_NEAR(range->second, kFurthest, kRangeResolution) << axis;
    }
}

TEST(AxisRange, EndsAtTheSingularityMargin) {
    constexpr int kGamma = 5;
    constexpr double kMargin = 0.05;
    PlatformGeometry roomy = laboratoryPlatform();
    for (Leg& leg : roomy.legs) {
        leg.minLength *= 0.5;
        leg.maxLength *= 2.0;
    }
    const MotionPlanner planner(makeModel(roomy), plannerSettings({}, roomy));
    const auto range = axisRange(planner, Pose{}, kGamma);
    ASSERT_TRUE(range);
    EXPECT_NEAR(planner.model().singularity(alongAxis(kGamma, range->second)).smallestSingularValue, kMargin,
                kRangeResolution);
}

TEST(AxisRange, OfAJogEndsWhereTheJogWould) {
    constexpr double kMetres = 2e-4; // of the bisection
    const MotionPlanner planner(makeModel(laboratoryPlatform()), plannerSettings({}, laboratoryPlatform()));
    const Pose here = poseOf(3, -2, 5, 4, -3, 10);
    for (const JogFrame frame : {JogFrame::Base, JogFrame::Platform}) {
        for (int axis = 0; axis < 6; ++axis) {
            const JogDirection direction{axis, axis % 2 == 0, frame};
            const auto way = jogRange(planner, here, direction);
            ASSERT_TRUE(way);
            EXPECT_TRUE(planner.check(stepped(here, direction, *way)).ok()) << axis;
            EXPECT_FALSE(planner.check(stepped(here, direction, *way + kMetres)).ok()) << axis;
        }
    }
    EXPECT_FALSE(jogRange(planner, poseOf(0, 0, 300, 0, 0, 0), {}));
}

} // namespace
} // namespace hexapose
