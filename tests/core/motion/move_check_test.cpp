// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Whole moves, against an oracle that looks at many more places than the check does.

#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/jacobian.h"
#include "core/kinematics/singularity.h"
#include "core/motion/leg_path_check.h"
#include "core/motion/limits.h"
#include "core/motion/pose_motion_check.h"
#include "core/motion/sine_sweep.h"
#include "core/motion/straight_motion.h"
#include "core/record/motion_check_words.h"
#include "tests/core/motion/poses.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

namespace hexapose {
namespace {

using testing::poseMm;

constexpr int kOracleSamples = 5000;
constexpr int kMoves = 150;

class MoveCheck : public ::testing::Test {
protected:
    MoveCheck() {
        m_limits = motionLimits(m_machine, std::nullopt, std::nullopt);
        m_limits.legSpeed = m_bounds.legSpeed;
        m_limits.legAcceleration = m_bounds.legAcceleration;
    }
    StraightMotion motion(const Pose& from, const Pose& to) const { return {m_machine, from, to, m_bounds}; }
    MotionCheck checkMove(const Pose& from, const Pose& to) const {
        return checkMotion(m_machine, m_limits, motion(from, to));
    }
    /// P so far from home, at right angles to a leg.
    Pose beside(double distance) const {
        const Eigen::Vector3d leg = geometricJacobian(m_machine, Pose{}).row(kLeg).head<3>();
        return {distance * leg.unitOrthogonal(), {}};
    }
    static constexpr int kLeg = 2;
    const PlatformGeometry m_machine = testing::laboratory();
    const MotionBounds m_bounds = withDefaults(MotionBounds{}, m_machine);
    MotionLimits m_limits;
};

/// The shortest stroke is set near the length that a leg has where it is shortest, somewhere on the way.
TEST_F(MoveCheck, AcceptsWhatKeepsTheLimitsAndNothingElse) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int accepted = 0, refused = 0;
    for (int i = 0; i < kMoves; ++i) {
        PoseVector a, b;
        for (int k = 0; k < 6; ++k) {
            const double range = k < 3 ? 0.025 : 0.2;
            a[k] = range * unit(random);
            b[k] = range * unit(random);
        }
        const Pose from = Pose::fromVector(a), to = Pose::fromVector(b);
        const StraightMotion whole = motion(from, to);
        const auto lengthsAt = [&](int k) {
            return legLengths(m_machine, whole.at(whole.duration() * k / kOracleSamples).pose);
        };
        LegLengths least = LegLengths::Constant(1.0);
        for (int k = 0; k <= kOracleSamples; ++k)
            least = least.cwiseMin(lengthsAt(k));
        const LegLengths ends = lengthsAt(0).cwiseMin(lengthsAt(kOracleSamples));
        int leg = 0;
        const double dip = (ends - least).maxCoeff(&leg);
        if (dip < 2e-5)
            continue; // every leg is shortest at an end
        m_limits.minLength.setZero();
        m_limits.maxLength.setConstant(1.0);
        m_limits.minLength[leg] = least[leg] + 0.5 * dip * unit(random);
        const bool good = least[leg] >= m_limits.minLength[leg];
        const MotionCheck check = checkMove(from, to);
        EXPECT_EQ(check.ok(), good) << i << ": " << toWords(check);
        ++(good ? accepted : refused);
    }
    EXPECT_GT(accepted, 10);
    EXPECT_GT(refused, 10);
}

/// A way at right angles to a leg: the leg is shortest in its middle.
TEST_F(MoveCheck, SaysWhereOnTheWayAStrokeIsLeft) {
    m_limits.minLength[kLeg] = m_machine.homeLengths()[kLeg] + 1e-4;
    ASSERT_TRUE(checkPose(m_machine, m_limits, beside(-0.02)).ok());
    ASSERT_TRUE(checkPose(m_machine, m_limits, beside(0.02)).ok());
    const MotionCheck check = checkMove(beside(-0.02), beside(0.02));
    EXPECT_EQ(check.reason, MotionCheck::Reason::LegBelowMin);
    EXPECT_EQ(check.leg, kLeg + 1);
    EXPECT_GT(check.fraction, 0.1);
    EXPECT_LT(check.fraction, 0.5);
    EXPECT_NE(toWords(check).find(" below min_mm at "), std::string::npos) << toWords(check);
}

/// Over a thousandth of the way: samples alone would miss it.
TEST_F(MoveCheck, FindsWhatLiesBetweenItsSamples) {
    const double home = m_machine.homeLengths()[kLeg];
    m_limits.minLength[kLeg] = home + 1e-9;
    EXPECT_EQ(checkMove(beside(-0.0213), beside(0.02)).reason, MotionCheck::Reason::LegBelowMin);
    m_limits.minLength[kLeg] = home - 1e-9;
    EXPECT_TRUE(checkMove(beside(-0.0213), beside(0.02)).ok());
}

TEST_F(MoveCheck, NamesEnvelopeSpeedAndAcceleration) {
    m_limits.envelope.furthest[5] = radiansFromDeg(4.0);
    const Pose to = poseMm(12, -4, 40, 0, 0, 5);
    MotionCheck check = checkMove(Pose{}, to);
    EXPECT_EQ(check.reason, MotionCheck::Reason::OutsideEnvelope);
    EXPECT_EQ(check.axis, 6);
    EXPECT_NE(toWords(check).find("gamma outside the envelope at "), std::string::npos);
    m_limits.envelope = {};
    m_limits.legSpeed = 0.5 * m_bounds.legSpeed;
    check = checkMove(Pose{}, to);
    EXPECT_EQ(check.reason, MotionCheck::Reason::LegSpeed);
    EXPECT_GT(check.leg, 0);
    m_limits.legSpeed = m_bounds.legSpeed;
    m_limits.legAcceleration = 0.1 * m_bounds.legAcceleration;
    EXPECT_EQ(checkMove(Pose{}, to).reason, MotionCheck::Reason::LegAcceleration);
    m_limits.legAcceleration = m_bounds.legAcceleration;
    EXPECT_TRUE(checkMove(Pose{}, to).ok());
}

TEST_F(MoveCheck, RefusesAMotionThatComesTooNearToTheOtherSide) {
    const Pose to = poseMm(0, 0, 10, 0, 0, 20);
    ASSERT_TRUE(checkMove(Pose{}, to).ok());
    m_limits.leastDeterminantRatio = 0.999; // of home's: the turn leaves it
    const MotionCheck check = checkMove(Pose{}, to);
    EXPECT_EQ(check.reason, MotionCheck::Reason::WrongSideOfSingularity);
    EXPECT_LT(check.value, 0.999);
}

TEST_F(MoveCheck, JudgesSweepsToo) {
    EXPECT_TRUE(checkMotion(m_machine, m_limits, SineSweep(Pose{}, {2, 0.005, 0.1, 0.5, 10.0})).ok());
    EXPECT_EQ(checkMotion(m_machine, m_limits, SineSweep(Pose{}, {2, 0.005, 0.1, 5.0, 10.0})).reason,
              MotionCheck::Reason::LegSpeed);
    m_limits.legSpeed = m_limits.legAcceleration = 100.0;
    EXPECT_EQ(checkMotion(m_machine, m_limits, SineSweep(Pose{}, {2, 0.080, 0.1, 1.0, 10.0})).leg > 0, true);
}

TEST_F(MoveCheck, RefusesAMotionThroughASingularPose) {
    m_limits.minLength.setZero();
    m_limits.maxLength.setConstant(10.0);
    const MotionCheck check = checkMove(Pose{}, poseMm(0, 0, 0, 0, 0, 120));
    EXPECT_EQ(check.reason, MotionCheck::Reason::PathNearSingular);
    EXPECT_NEAR(check.fraction, 0.72, 0.1) << "yaw 90 of 120 degrees, a little before";
}

} // namespace
} // namespace hexapose
