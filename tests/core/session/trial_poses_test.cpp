// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/session/trial_poses.h"

#include "core/base/input_error.h"
#include "core/base/units.h"
#include "core/geometry/geometry_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace hexapose {
namespace {

PlatformGeometry laboratory() {
    return loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
}

TEST(TrialPoses, BeginWithThePublishedPoseWhereItCanBeReached) {
    const std::vector<Pose> poses = trialPoses(PlatformModel(laboratory()), PoseEnvelope{}, 3);
    ASSERT_EQ(poses.size(), 4U);
    EXPECT_DOUBLE_EQ(poses.front().offset.z(), 0.040);
}

TEST(TrialPoses, StayInTheEnvelope) {
    PoseEnvelope envelope;
    envelope.furthest.head<3>().setConstant(0.005);
    envelope.furthest.tail<3>().setConstant(radiansFromDeg(2.0));
    for (const Pose& pose : trialPoses(PlatformModel(laboratory()), envelope, 3))
        EXPECT_TRUE((pose.toVector().cwiseAbs().array() <= envelope.furthest.array()).all());
}

/// Base and platform are similar hexagons: every pose is singular.
TEST(TrialPoses, APlatformThatIsSingularEverywhereIsRefusedWithTheReason) {
    PlatformGeometry geometry = laboratory();
    geometry.name = "similar";
    geometry.p_OP_home_B = {0.0, 0.0, 0.24};
    for (int i = 0; i < kLegCount; ++i) {
        const double angle = i * 1.0471975511965976;
        Leg& leg = geometry.legs[static_cast<std::size_t>(i)];
        leg.p_OA_B = {0.15 * std::cos(angle), 0.15 * std::sin(angle), 0.0};
        leg.p_PB_P = {0.10 * std::cos(angle), 0.10 * std::sin(angle), 0.0};
        leg.minLength = 0.190;
        leg.maxLength = 0.310;
    }
    try {
        trialPoses(PlatformModel(geometry), PoseEnvelope{}, 3);
        FAIL() << "poses of a platform that has none";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("similar"));
        EXPECT_THAT(error.what(), testing::HasSubstr("singular"));
    }
}

TEST(TrialPoses, AnEnvelopeThatLeavesNothingIsRefused) {
    PoseEnvelope envelope;
    envelope.furthest.setConstant(1e-12);
    EXPECT_THROW(trialPoses(PlatformModel(laboratory()), envelope, 3), InputError);
}

} // namespace
} // namespace hexapose
