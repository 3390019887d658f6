// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/motion/limits.h"

#include "core/kinematics/inverse_kinematics.h"
#include "core/motion/leg_path_check.h"
#include "core/motion/pose_motion_check.h"
#include "core/record/motion_check_words.h"
#include "tests/core/motion/poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace hexapose {
namespace {

using testing::poseMm;

class LimitsTest : public ::testing::Test {
protected:
    PlatformGeometry m_geometry = testing::laboratory();
    const PlatformModel m_model{m_geometry};
    MotionLimits m_limits = motionLimits(m_geometry, std::nullopt, std::nullopt);
};

TEST_F(LimitsTest, TakesTheNarrowerOfPlatformAndController) {
    const MotionLimits narrowed = motionLimits(m_geometry, 0.26, 0.9);
    EXPECT_DOUBLE_EQ(narrowed.minLength[0], 0.26);
    EXPECT_DOUBLE_EQ(narrowed.maxLength[5], 0.35);
}

TEST_F(LimitsTest, NamesTheLegThatIsFurthestOutWithValueAndBound) {
    const Pose high = poseMm(30, 0, 60, 0, 0, 0);
    const LegLengths lengths = legLengths(m_geometry, high);
    int longest = 0;
    lengths.maxCoeff(&longest);
    const MotionCheck check = checkPose(m_model, m_limits, high);
    EXPECT_EQ(check.reason, MotionCheck::Reason::LegAboveMax);
    EXPECT_EQ(check.leg, longest + 1);
    EXPECT_DOUBLE_EQ(check.value, lengths[longest]);
    EXPECT_DOUBLE_EQ(check.bound, 0.35);
    EXPECT_EQ(toWords(check), "leg " + std::to_string(longest + 1) + " above max_mm");
    EXPECT_EQ(checkPose(m_model, m_limits, poseMm(0, 0, -60, 0, 0, 0)).reason,
              MotionCheck::Reason::LegBelowMin);
}

/// An independent oracle: a random pose is accepted exactly when its lengths are inside the strokes.
TEST_F(LimitsTest, AgreesWithTheStrokesOnRandomPoses) {
    m_limits.singularityMargin = 0.0;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> mm(-60, 60);
    std::uniform_real_distribution<double> deg(-20, 20);
    int accepted = 0;
    for (int k = 0; k < 2000; ++k) {
        const Pose pose = poseMm(mm(random), mm(random), mm(random), deg(random), deg(random), deg(random));
        const LegLengths lengths = legLengths(m_geometry, pose);
        const bool inside = lengths.minCoeff() >= 0.25 && lengths.maxCoeff() <= 0.35;
        EXPECT_EQ(checkPose(m_model, m_limits, pose).ok(), inside);
        accepted += inside ? 1 : 0;
    }
    EXPECT_GT(accepted, 200);
    EXPECT_LT(accepted, 1800);
}

TEST_F(LimitsTest, AMotionMayBeginAHairBeyondAStrokeAndLeave) {
    constexpr double kWithin = 2e-4, kBeyond = 5e-5;
    LegLengths lengths = m_limits.maxLength;
    lengths[2] += kBeyond;
    lengths[3] += 2 * kWithin;
    lengths[4] = m_limits.minLength[4] - kBeyond;
    const MotionLimits from = limitsFrom(m_limits, lengths, kWithin);
    EXPECT_EQ(from.maxLength[1], m_limits.maxLength[1]);
    EXPECT_EQ(from.maxLength[2], lengths[2]) << "and no further";
    EXPECT_EQ(from.maxLength[3], m_limits.maxLength[3]) << "too far out for a measurement's rounding";
    EXPECT_EQ(from.minLength[4], lengths[4]);
}

TEST_F(LimitsTest, RefusesNumbersThatAreNot) {
    for (int k = 0; k < 6; ++k) {
        PoseVector v = PoseVector::Zero();
        v[k] =
            k % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
        EXPECT_EQ(toWords(checkPose(m_model, m_limits, Pose::fromVector(v))), "invalid-input");
    }
}

TEST_F(LimitsTest, RefusesASingularPose) {
    m_limits.minLength.setZero();
    m_limits.maxLength.setConstant(10.0);
    const MotionCheck check = checkPose(m_model, m_limits, poseMm(0, 0, 0, 0, 0, 90));
    EXPECT_EQ(check.reason, MotionCheck::Reason::NearSingular);
    EXPECT_LT(check.value, m_limits.singularityMargin);
}

TEST_F(LimitsTest, AcceptsTheLegPathOfAnOrdinaryMove) {
    EXPECT_TRUE(checkLegPath(m_model, m_limits, Pose{}, poseMm(12, -4, 40, 0, 0, 5)).ok());
    EXPECT_TRUE(checkLegPath(m_model, m_limits, poseMm(12, -4, 40, 0, 0, 5), Pose{}).ok());
}

TEST_F(LimitsTest, RefusesALegPathThroughASingularityThoughBothEndsAreGood) {
    m_limits.minLength.setZero();
    m_limits.maxLength.setConstant(10.0);
    const Pose turned = poseMm(0, 0, -60, -80, -80, -120);
    ASSERT_TRUE(checkPose(m_model, m_limits, turned).ok());
    const MotionCheck check = checkLegPath(m_model, m_limits, Pose{}, turned);
    EXPECT_EQ(check.reason, MotionCheck::Reason::PathNearSingular);
    EXPECT_GT(check.fraction, 0.5);
    EXPECT_LT(check.fraction, 1.0);
    EXPECT_NE(toWords(check).find("path near singular at "), std::string::npos);
}

/// The legs of yaw 120 deg have a twin pose, and the straight leg path from home leads to that one: identical
/// legs, no singularity met, and still not the target.
TEST_F(LimitsTest, RefusesALegPathThatEndsAtTheTwinOfTheTarget) {
    m_limits.minLength.setZero();
    m_limits.maxLength.setConstant(10.0);
    const Pose turned = poseMm(0, 0, 0, 0, 0, 120);
    EXPECT_EQ(checkPose(m_model, m_limits, turned).reason, MotionCheck::Reason::WrongSideOfSingularity);
    m_limits.leastDeterminantRatio = -10.0;
    ASSERT_TRUE(checkPose(m_model, m_limits, turned).ok());
    EXPECT_EQ(checkLegPath(m_model, m_limits, Pose{}, turned).reason, MotionCheck::Reason::OtherAssemblyMode);
}

} // namespace
} // namespace hexapose
