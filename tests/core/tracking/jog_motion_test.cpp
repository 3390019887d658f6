// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// The reference of a jog, on a platform that is always where it should be.

#include "core/tracking/jog_motion.h"

#include "core/kinematics/inverse_kinematics.h"
#include "tests/core/motion/poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hexapose {
namespace {

using testing::laboratory;

constexpr double kJogCycle = 0.01; ///< s
constexpr double kOfLimit = 1e-6;  ///< rounding, of a limit

class JogMotionTest : public ::testing::Test {
protected:
    struct Most {
        double pace = 0.0, acceleration = 0.0, jerk = 0.0;
    };
    /// Held, held at half speed, held at full speed, released; returns the largest values reached.

    Most ride(const JogDirection& direction) {
        WorkspaceController controller(m_model, {8.0, m_bounds.legSpeed, 0.01, 0.25, 5e-5, 5e-4});
        JogMotion jog(controller, m_model, m_bounds, m_model->actuators({}), {});
        Most most;
        double pace = 0.0, acceleration = 0.0;
        for (int k = 0; k < 240; ++k) {
            if (k < 120)
                jog.hold(direction, k < 60 || k >= 90 ? 1.0 : 0.5);
            else
                jog.release();
            const Pose pose = jog.reference()->pose;
            jog.step({kJogCycle, 1.0, m_model->actuators(pose), pose, m_limits});
            const Twist twist = jog.reference()->twist;
            const double now = direction.axis < 3 ? twist.head<3>().norm() : twist.tail<3>().norm();
            const double change = (now - pace) / kJogCycle;
            most.pace = std::max(most.pace, now);
            most.acceleration = std::max(most.acceleration, std::abs(change));
            most.jerk = std::max(most.jerk, std::abs(change - acceleration) / kJogCycle);
            pace = now;
            acceleration = change;
        }
        EXPECT_TRUE(jog.finished());
        EXPECT_FALSE(jog.takeEvent()) << "no limit was near";
        return most;
    }

    const PlatformGeometry m_machine = laboratory();
    const MotionLimits m_limits = motionLimits(m_machine, {}, {});
    const MotionBounds m_bounds = withDefaults({}, m_machine);
    const SharedModel m_model = makeModel(m_machine);
};

TEST_F(JogMotionTest, KeepsToItsSpeedAccelerationAndJerkWhenHeldSlowedAndReleased) {
    for (const bool up : {true, false}) {
        const Most along = ride({0, up});
        EXPECT_GT(along.pace, 0.5 * m_bounds.speed);
        EXPECT_LE(along.pace, (1.0 + kOfLimit) * m_bounds.speed);
        EXPECT_LE(along.acceleration, (1.0 + kOfLimit) * m_bounds.acceleration);
        EXPECT_LE(along.jerk, (1.0 + kOfLimit) * m_bounds.jerk);
        const Most about = ride({5, up});
        EXPECT_GT(about.pace, 0.5 * m_bounds.angularSpeed);
        EXPECT_LE(about.pace, (1.0 + kOfLimit) * m_bounds.angularSpeed);
        EXPECT_LE(about.acceleration, (1.0 + kOfLimit) * m_bounds.angularAcceleration);
        EXPECT_LE(about.jerk, (1.0 + kOfLimit) * m_bounds.angularJerk);
    }
}

} // namespace
} // namespace hexapose
