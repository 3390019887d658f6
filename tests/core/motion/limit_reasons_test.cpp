// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Each limit by itself: what is refused, and for which reason.

#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/singularity.h"
#include "core/motion/limits.h"
#include "tests/core/motion/poses.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hexapose {
namespace {

using testing::laboratory;
using testing::poseMm;

using Reason = MotionCheck::Reason;

TEST(LimitReasons, OfAControllerWithShorterStrokes) {
    const MotionLimits narrowed = motionLimits(laboratory(), 0.26, 0.33);
    EXPECT_DOUBLE_EQ(narrowed.minLength[2], 0.26);
    EXPECT_DOUBLE_EQ(narrowed.maxLength[2], 0.33);
}

TEST(LimitReasons, OfALengthThatIsNoNumber) {
    const MotionLimits limits = motionLimits(laboratory(), {}, {});
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        LegLengths lengths = legLengths(laboratory(), Pose{});
        EXPECT_TRUE(checkLegs(limits, lengths).ok());
        lengths[3] = bad;
        EXPECT_EQ(checkLegs(limits, lengths).reason, Reason::NotFinite);
    }
}

TEST(LimitReasons, OfAnEnvelopeOnBothSidesOfHome) {
    PoseEnvelope envelope;
    envelope.furthest << 0.01, 0.01, 0.01, 0.1, 0.1, 0.1;
    for (int axis = 0; axis < 6; ++axis) {
        for (const double side : {1.0, -1.0}) {
            PoseVector coordinates = PoseVector::Zero();
            coordinates[axis] = side * 0.99 * envelope.furthest[axis];
            EXPECT_FALSE(outsideEnvelope(envelope, Pose::fromVector(coordinates))) << axis << side;
            coordinates[axis] = side * 1.01 * envelope.furthest[axis];
            const auto outside = outsideEnvelope(envelope, Pose::fromVector(coordinates));
            ASSERT_TRUE(outside) << axis << side;
            EXPECT_EQ(outside->reason, Reason::OutsideEnvelope);
            EXPECT_EQ(outside->axis, axis + 1);
            EXPECT_EQ(outside->value, coordinates[axis]);
        }
    }
}

TEST(LimitReasons, OfAMarginToTheSingularPoses) {
    const Pose pose = poseMm(5, 3, 10, 2, 1, 4);
    const double smallest = singularityMeasure(laboratory(), pose).smallestSingularValue;
    MotionLimits limits = motionLimits(laboratory(), {}, {});
    limits.singularityMargin = 0.99 * smallest;
    EXPECT_TRUE(checkPose(PlatformModel(laboratory()), limits, pose).ok());
    limits.singularityMargin = 1.01 * smallest;
    const MotionCheck check = checkPose(PlatformModel(laboratory()), limits, pose);
    EXPECT_EQ(check.reason, Reason::NearSingular);
    EXPECT_EQ(check.value, smallest);
    EXPECT_EQ(check.bound, limits.singularityMargin);
}

} // namespace
} // namespace hexapose
