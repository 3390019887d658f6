// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Whole moves, against an oracle that looks at many more places than the check does.

#include "core/kinematics/inverse_kinematics.h"
#include "core/kinematics/jacobian.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "core/kinematics/singularity.h"
#include "core/motion/leg_path_check.h"
#include "core/motion/limits.h"
#include "core/motion/path_sample.h"
#include "core/motion/pose_motion_check.h"
#include "core/motion/sine_sweep.h"
#include "core/motion/straight_motion.h"
#include "core/record/motion_check_words.h"
#include "tests/core/motion/poses.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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
    StraightMotion motion(const Pose& from, const Pose& to) const { return {m_model, from, to, m_bounds}; }
    MotionCheck checkMove(const Pose& from, const Pose& to) const {
        return checkMotion(m_model, m_limits, motion(from, to));
    }
    /// P so far from home, at right angles to a leg.
    Pose beside(double distance) const {
        const Eigen::Vector3d leg = geometricJacobian(m_machine, Pose{}).row(kLeg).head<3>();
        return {distance * leg.unitOrthogonal(), {}};
    }
    static constexpr int kLeg = 2;
    const PlatformGeometry m_machine = testing::laboratory();
    const PlatformModel m_model{m_machine};
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
    ASSERT_TRUE(checkPose(m_model, m_limits, beside(-0.02)).ok());
    ASSERT_TRUE(checkPose(m_model, m_limits, beside(0.02)).ok());
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

/// What the checks rely on between their samples: the Jacobian changes by no more than it says.
TEST_F(MoveCheck, BoundsTheChangeOfTheJacobian) {
    const PlatformModel model(m_machine);
    const LegEquations& equations = model.equations();
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto draw = [&] { return Eigen::Vector3d(unit(random), unit(random), unit(random)); };
    double nearest = 0.0;
    for (int i = 0; i < 3000; ++i) {
        Placement place = equations.placementOf({0.03 * draw(), {unit(random), unit(random), unit(random)}});
        const PathSample here(equations, place);
        const double shift = std::pow(10.0, -1.0 - 3.0 * std::abs(unit(random)));
        const double turn = std::pow(10.0, -1.0 - 3.0 * std::abs(unit(random)));
        place.centroid += shift * draw().normalized();
        const Eigen::Quaterniond turned =
            Eigen::AngleAxisd(turn, draw().normalized()) *
            Eigen::Quaterniond(place.w, place.v[0], place.v[1], place.v[2]).normalized();
        const PathSample there(equations, {place.centroid, turned.w(), turned.vec()});
        const double change = (there.jacobian() - here.jacobian()).norm();
        const double bound = here.jacobianChange(shift, turn);
        EXPECT_LE(change, bound);
        nearest = std::max(nearest, change / bound);
    }
    EXPECT_GT(nearest, 0.6) << "no wider than it must be";
    EXPECT_EQ(PathSample(equations, equations.placementOf(Pose{})).jacobianChange(10.0, 0.0),
              std::numeric_limits<double>::infinity());
}

/// Leg paths against an oracle that solves 5000 poses on each. The margin is a little below what the ends
/// keep, so that some paths keep it all along and others do not.
TEST_F(MoveCheck, AcceptsLegPathsThatKeepTheMarginAndNoOthers) {
    m_limits.minLength.setZero();
    m_limits.maxLength.setConstant(1.0);
    const PlatformModel model(m_machine);
    const NewtonRaphson newton(m_machine, NewtonOptions{});
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int accepted = 0, refused = 0;
    for (int i = 0; i < 100; ++i) {
        PoseVector a, b;
        for (int k = 0; k < 6; ++k) {
            a[k] = (k < 3 ? 0.05 : 0.8) * unit(random);
            b[k] = (k < 3 ? 0.05 : 0.8) * unit(random);
        }
        const Pose from = Pose::fromVector(a), to = Pose::fromVector(b);
        m_limits.singularityMargin = 0.99 * model.singularity(to).smallestSingularValue;
        if (!checkPose(model, m_limits, to).ok())
            continue;
        const LegLengths start = model.actuators(from), way = model.actuators(to) - start;
        double least = 1.0;
        Pose pose = from;
        for (int k = 0; k <= kOracleSamples && least > 0.0; ++k) {
            const ForwardResult result = newton.solve(start + way * k / kOracleSamples, pose);
            least = result.isUsable() ? std::min(least, model.singularity(result.pose).smallestSingularValue)
                                      : 0.0;
            pose = result.pose;
        }
        const MotionCheck check = checkLegPath(model, m_limits, from, to);
        if (check.ok()) {
            ++accepted;
            EXPECT_GE(least, m_limits.singularityMargin - kMarginResolution) << i;
        } else {
            ++refused;
            EXPECT_EQ(check.reason, MotionCheck::Reason::PathNearSingular) << i;
            EXPECT_LT(least, m_limits.singularityMargin + 1e-6) << i;
        }
    }
    EXPECT_GT(accepted, 10);
    EXPECT_GT(refused, 3);
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
    EXPECT_TRUE(checkMotion(m_model, m_limits, SineSweep(Pose{}, {2, 0.005, 0.1, 0.5, 10.0})).ok());
    EXPECT_EQ(checkMotion(m_model, m_limits, SineSweep(Pose{}, {2, 0.005, 0.1, 5.0, 10.0})).reason,
              MotionCheck::Reason::LegSpeed);
    m_limits.legSpeed = m_limits.legAcceleration = 100.0;
    EXPECT_EQ(checkMotion(m_model, m_limits, SineSweep(Pose{}, {2, 0.080, 0.1, 1.0, 10.0})).leg > 0, true);
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
