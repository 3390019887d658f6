// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// Which limits MotionPlanner plans under.
#include "core/base/units.h"
#include "core/motion/motion_planner.h"
#include "tests/core/motion/poses.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

constexpr double kSlack = 2e-4; ///< m

Pose raised(double mm) {
    Pose pose;
    pose.offset.z() = metresFromMm(mm);
    return pose;
}

class PlannerLimits : public ::testing::Test {
protected:
    const PlatformGeometry m_machine = testing::laboratory();
    const MotionPlanner::Settings m_settings{withDefaults(MotionBounds{}, m_machine), {}, kSlack};
    MotionPlanner m_planner{makeModel(m_machine), m_settings};
};

TEST_F(PlannerLimits, AreThoseOfThePlatformAndOfTheSettings) {
    const MotionLimits& limits = m_planner.limits();
    EXPECT_EQ(limits.legSpeed, m_settings.bounds.legSpeed);
    EXPECT_EQ(limits.legAcceleration, m_settings.bounds.legAcceleration);
    for (int i = 0; i < kLegCount; ++i) {
        EXPECT_EQ(limits.minLength[i], m_machine.legs[static_cast<std::size_t>(i)].minLength);
        EXPECT_EQ(limits.maxLength[i], m_machine.legs[static_cast<std::size_t>(i)].maxLength);
    }
}

TEST_F(PlannerLimits, OfTheControllerNarrowAndAreForgottenWithIt) {
    ASSERT_TRUE(m_planner.check(raised(40.0)).ok());
    const double narrow = m_planner.model().actuators(raised(20.0)).maxCoeff();
    m_planner.setControllerLimits(std::nullopt, narrow);
    EXPECT_EQ(m_planner.check(raised(40.0)).reason, MotionCheck::Reason::LegAboveMax);
    EXPECT_TRUE(m_planner.check(raised(19.0)).ok());
    m_planner.setControllerLimits(std::nullopt, std::nullopt);
    EXPECT_TRUE(m_planner.check(raised(40.0)).ok());
}

TEST_F(PlannerLimits, OfTheControllerStayWhenTheSettingsChange) {
    const double narrow = m_planner.model().actuators(raised(20.0)).maxCoeff();
    m_planner.setControllerLimits(std::nullopt, narrow);
    MotionPlanner::Settings settings = m_settings;
    settings.envelope.furthest[2] = metresFromMm(10.0);
    m_planner.setSettings(settings);
    EXPECT_EQ(m_planner.limits().maxLength.maxCoeff(), narrow);
    EXPECT_EQ(m_planner.check(raised(15.0)).reason, MotionCheck::Reason::OutsideEnvelope);
    EXPECT_TRUE(m_planner.check(raised(9.0)).ok());
}

TEST_F(PlannerLimits, OfTheEnvelopeStayWhenTheControllerChanges) {
    MotionPlanner::Settings settings = m_settings;
    settings.envelope.furthest[2] = metresFromMm(10.0);
    m_planner.setSettings(settings);
    m_planner.setControllerLimits(std::nullopt, std::nullopt);
    EXPECT_EQ(m_planner.check(raised(15.0)).reason, MotionCheck::Reason::OutsideEnvelope);
}

/// What is asked beforehand and what is planned are one answer.
TEST_F(PlannerLimits, HoldForAPlanAsForItsCheck) {
    for (const MotionMode mode : {MotionMode::Joint, MotionMode::Workspace})
        for (const double mm : {20.0, 400.0}) {
            const PlannedMotion planned =
                m_planner.plan({m_planner.model().actuators(Pose{}), Pose{}}, StraightMove{raised(mm), mode});
            EXPECT_EQ(planned.check.reason, m_planner.check(Pose{}, raised(mm), mode).reason);
            EXPECT_EQ(planned.check.ok(), mm < 100.0);
            EXPECT_EQ(planned.limits, m_planner.limits());
        }
}

/// A leg that a measurement's rounding puts beyond the end of its stroke may start there.
TEST_F(PlannerLimits, LeaveALegWhereItStarts) {
    m_planner.setControllerLimits(std::nullopt,
                                  m_planner.model().actuators(Pose{}).maxCoeff() - 0.5 * kSlack);
    EXPECT_GE(m_planner.limitsAt(Pose{}).maxLength.maxCoeff(),
              m_planner.model().actuators(Pose{}).maxCoeff());
    EXPECT_LT(m_planner.limitsAt(raised(20.0)).maxLength.maxCoeff(),
              m_planner.model().actuators(raised(20.0)).maxCoeff());
}

} // namespace
} // namespace hexapose
