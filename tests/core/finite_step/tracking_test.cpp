// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// Pose, velocity and acceleration over a motion, against what is known otherwise.
#include "core/finite_step/motion_tracking.h"
#include "core/finite_step/node_path.h"
#include "core/kinematics/jacobian.h"
#include "core/kinematics/newton/newton_raphson.h"
#include "tests/core/finite_step/finite_step_fixture.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace hexapose::testing::tracking_test {
namespace {

constexpr double kPart = 0.05; ///< of errors found independently of this implementation

/// Largest errors over a track, mm and deg, and those per s and s2.
struct Worst {
    double mm = 0, deg = 0, mmS = 0, degS = 0, mmS2 = 0, degS2 = 0;
};
Worst worstOf(const Track& track) {
    Worst worst;
    for (const TrackRow& row : track.rows) {
        const PoseErrors pose = poseErrors(row.computed, row.exact);
        const auto raise = [](double& most, double value) { most = std::max(most, value); };
        raise(worst.mm, mmFromMetres(pose.position.norm()));
        raise(worst.deg, degFromRadians(pose.turn));
        raise(worst.mmS, mmFromMetres((row.computed.velocity - row.exact.velocity).norm()));
        raise(worst.degS, degFromRadians((row.computed.angularVelocity - row.exact.angularVelocity).norm()));
        raise(worst.mmS2, mmFromMetres((row.computed.acceleration - row.exact.acceleration).norm()));
        raise(worst.degS2,
              degFromRadians((row.computed.angularAcceleration - row.exact.angularAcceleration).norm()));
    }
    return worst;
}

Track referenceTrack(const StepSystem& system, const TrackOptions& options) {
    return trackMotion(system, ReferenceDrive(system.mechanism(), 2.0), options);
}

TEST(Tracking, ClosedWithEquationsHasTheErrorsOfThePrototype) {
    const Worst worst =
        worstOf(referenceTrack(shippedSystem("6-ups"), {1000, StepForm::Closed, TrackRates::Equations}));
    EXPECT_NEAR(worst.mm / 7.4e-5, 1.0, kPart) << worst.mm;
    EXPECT_NEAR(worst.deg / 5.2e-5, 1.0, kPart) << worst.deg;
    EXPECT_NEAR(worst.mmS / 5.9e-5, 1.0, kPart) << worst.mmS;
    EXPECT_NEAR(worst.degS / 2.1e-5, 1.0, kPart) << worst.degS;
    EXPECT_NEAR(worst.mmS2 / 5.6e-5, 1.0, kPart) << worst.mmS2;
    EXPECT_NEAR(worst.degS2 / 1.8e-5, 1.0, kPart) << worst.degS2;
}

TEST(Tracking, OpenWithAveragesHasTheErrorsOfThePrototype) {
    const Worst worst =
        worstOf(referenceTrack(shippedSystem("6-ups"), {1000, StepForm::Open, TrackRates::Averages}));
    EXPECT_NEAR(worst.mm / 3.7e-2, 1.0, kPart) << worst.mm;
    EXPECT_NEAR(worst.deg / 2.2e-2, 1.0, kPart) << worst.deg;
    EXPECT_NEAR(worst.mmS / 0.184, 1.0, kPart) << worst.mmS;
    EXPECT_NEAR(worst.degS / 8.2e-2, 1.0, kPart) << worst.degS;
    EXPECT_NEAR(worst.mmS2 / 0.83, 1.0, kPart) << worst.mmS2;
    EXPECT_NEAR(worst.degS2 / 0.31, 1.0, kPart) << worst.degS2;
}

/// A difference quotient over a whole step, from the given velocity at its beginning to the average in its
/// middle, halves the first acceleration: an error that no number of steps takes away.
TEST(Tracking, TheFirstSampleIsNoWorseThanTheOthers) {
    for (const char* name : {"6-ups", "3-ups-s", "6-pus", "6-rus", "3-rps"})
        for (const TrackRates rates : {TrackRates::Equations, TrackRates::Averages})
            for (const StepForm form : {StepForm::Closed, StepForm::Corrected}) {
                const Track track = referenceTrack(shippedSystem(name), {1000, form, rates});
                ASSERT_EQ(track.rows.size(), 1001U) << name;
                const auto error = [&](std::size_t k) {
                    return (track.rows[k].computed.acceleration - track.rows[k].exact.acceleration).norm();
                };
                double later = 0.0;
                for (std::size_t k = 2; k < track.rows.size(); ++k)
                    later = std::max(later, error(k));
                EXPECT_LE(error(1), 1.5 * later + 1e-9) << name;
            }
}

/// A motion of the platform made up as a function of time, with its exact derivatives.
struct MadeUp {
    Pose pose;
    BodyMotion body;
};
MadeUp madeUpMotion(const PlatformGeometry& machine, double t) {
    const PoseVector amplitude = poseMmDeg(20, -15, 18, 9, -8, 12).toVector();
    PoseVector x, dx, ddx;
    for (int k = 0; k < 6; ++k) {
        const double rate = 1.0 + 0.3 * k, phase = 0.4 * k;
        x[k] = amplitude[k] * (std::sin(rate * t + phase) - std::sin(phase));
        dx[k] = amplitude[k] * rate * std::cos(rate * t + phase);
        ddx[k] = -amplitude[k] * rate * rate * std::sin(rate * t + phase);
    }
    MadeUp motion{Pose::fromVector(x), {}};
    BodyMotion& body = motion.body;
    body.R_BP = rotationMatrix(motion.pose.angles);
    body.p_OP_B = machine.p_OP_home_B + motion.pose.offset;
    body.velocity = dx.head<3>();
    body.acceleration = ddx.head<3>();
    const Eigen::Vector3d rates = dx.tail<3>();
    body.angularVelocity = eulerRateMatrix(motion.pose.angles) * rates;
    // E' by a central difference of analytic values: its error is far below the tolerances.
    constexpr double kStep = 1e-5;
    const auto shifted = [&](double step) {
        const Eigen::Vector3d angles = x.tail<3>() + step * rates;
        return eulerRateMatrix({angles[0], angles[1], angles[2]});
    };
    body.angularAcceleration = eulerRateMatrix(motion.pose.angles) * ddx.tail<3>() +
                               (shifted(kStep) - shifted(-kStep)) / (2.0 * kStep) * rates;
    return motion;
}

/// Exact lengths, rates and accelerations of the legs of a motion.
DriveState legOf(const PlatformGeometry& machine, std::size_t leg, const BodyMotion& body) {
    const Eigen::Vector3d arm = body.R_BP * machine.legs[leg].p_PB_P;
    const Eigen::Vector3d d = body.p_OP_B + arm - machine.legs[leg].p_OA_B;
    const Eigen::Vector3d& w = body.angularVelocity;
    const Eigen::Vector3d velocity = body.velocity + w.cross(arm);
    const Eigen::Vector3d acceleration =
        body.acceleration + body.angularAcceleration.cross(arm) + w.cross(w.cross(arm));
    const double length = d.norm(), rate = d.dot(velocity) / length;
    return {length, rate, (d.dot(acceleration) + velocity.squaredNorm() - rate * rate) / length};
}

Track madeUpTrack(const PlatformGeometry& machine, int steps, const TrackOptions& options) {
    TableDrive::Samples samples;
    samples.withRates = true;
    samples.states.resize(kLegCount);
    for (int k = 0; k <= steps; ++k) {
        samples.times.push_back(2.0 * k / steps);
        const BodyMotion body = madeUpMotion(machine, samples.times.back()).body;
        for (std::size_t i = 0; i < kLegCount; ++i)
            samples.states[i].push_back(legOf(machine, i, body));
    }
    return trackMotion(StepSystem(mechanismOf(machine), machine.name), TableDrive(samples), options);
}

TEST(Tracking, FindsAMadeUpMotion) {
    constexpr int kSteps = 400;
    for (const PlatformGeometry& machine : {laboratory(), octahedral(), asymmetric()}) {
        SCOPED_TRACE(machine.name);
        for (const StepForm form : {StepForm::Closed, StepForm::Corrected}) {
            Track track = madeUpTrack(machine, kSteps, {kSteps, form, TrackRates::Equations});
            ASSERT_EQ(track.rows.size(), kSteps + 1U);
            const Worst againstNewton = worstOf(track);
            for (TrackRow& row : track.rows)
                row.exact = madeUpMotion(machine, row.time).body;
            const Worst worst = worstOf(track);
            const double allowed = form == StepForm::Closed ? 3e-3 : 1e-5;
            EXPECT_LT(std::max({worst.mm, worst.deg, worst.mmS, worst.degS, worst.mmS2, worst.degS2}),
                      allowed);
            EXPECT_NEAR(againstNewton.mm, worst.mm, 1e-6);
            EXPECT_NEAR(againstNewton.mmS2, worst.mmS2, 1e-4);
        }
    }
}

TEST(Tracking, LegPowerIsPlatformPower) {
    const PlatformGeometry machine = laboratoryAtJoints();
    const Track track =
        referenceTrack(shippedSystem("6-ups"), {500, StepForm::Corrected, TrackRates::Equations});
    Eigen::Matrix<double, 6, 1> wrench;
    wrench << 3.0, -2.0, 9.0, 0.2, 0.5, -0.4; // N and N m, on the output point
    for (std::size_t k = 0; k < track.rows.size(); k += 25) {
        const BodyMotion& body = track.rows[k].computed;
        const Pose pose{body.p_OP_B - machine.p_OP_home_B, eulerAngles(body.R_BP)};
        const LegVector forces = geometricJacobian(machine, pose).transpose().inverse() * wrench;
        double legPower = 0.0;
        for (int i = 0; i < kLegCount; ++i)
            legPower += forces[i] * track.rows[k].drive[static_cast<std::size_t>(i)].rate;
        const double power = wrench.head<3>().dot(body.velocity) + wrench.tail<3>().dot(body.angularVelocity);
        EXPECT_NEAR(legPower, power, 1e-9 * std::max(1.0, std::abs(power)));
    }
}

/// The rates that come from the equations are those of the path: differences of exact nodes, of sixth order.
TEST(Tracking, RatesAreTheDerivativesOfThePath) {
    for (const char* name : {"6-ups", "3-ups-s", "6-pus", "6-rus", "3-rps"}) {
        SCOPED_TRACE(name);
        const StepSystem system = shippedSystem(name);
        constexpr int kSteps = 2000;
        const Track track = referenceTrack(system, {kSteps, StepForm::Corrected, TrackRates::Equations});
        ASSERT_FALSE(track.isSingular);
        const double h = 2.0 / kSteps;
        for (std::size_t k = 100; k < kSteps; k += 300) {
            const auto p = [&](int shift) {
                return track.rows[static_cast<std::size_t>(static_cast<int>(k) + 10 * shift)].exact.p_OP_B;
            };
            const double H = 10.0 * h;
            const Eigen::Vector3d velocity =
                (45.0 * (p(1) - p(-1)) - 9.0 * (p(2) - p(-2)) + (p(3) - p(-3))) / (60.0 * H);
            const Eigen::Vector3d acceleration =
                (270.0 * (p(1) + p(-1)) - 27.0 * (p(2) + p(-2)) + 2.0 * (p(3) + p(-3)) - 490.0 * p(0)) /
                (180.0 * H * H);
            EXPECT_LT((velocity - track.rows[k].computed.velocity).norm(), 1e-8);
            EXPECT_LT((acceleration - track.rows[k].computed.acceleration).norm(), 1e-6);
            const auto R = [&](int shift) {
                return track.rows[static_cast<std::size_t>(static_cast<int>(k) + 10 * shift)].exact.R_BP;
            };
            const auto w = [&](int shift) -> Eigen::Vector3d {
                return rotationVector(R(-shift), R(shift)) / (2.0 * shift * H);
            };
            const Eigen::Vector3d angular = (15.0 * w(1) - 6.0 * w(2) + w(3)) / 10.0;
            EXPECT_LT((angular - track.rows[k].computed.angularVelocity).norm(), 1e-6);
            const auto spin = [&](int shift) {
                return track.rows[static_cast<std::size_t>(static_cast<int>(k) + 10 * shift)]
                    .computed.angularVelocity;
            };
            const Eigen::Vector3d angularAcceleration =
                (45.0 * (spin(1) - spin(-1)) - 9.0 * (spin(2) - spin(-2)) + (spin(3) - spin(-3))) /
                (60.0 * H);
            EXPECT_LT((angularAcceleration - track.rows[k].computed.angularAcceleration).norm(), 1e-7);
        }
    }
}

TEST(Tracking, GoesOutAndBack) {
    const StepSystem system = shippedSystem("6-ups");
    TableDrive::Samples samples;
    for (int k = 0; k <= 200; ++k)
        samples.times.push_back(0.01 * k);
    const LegLengths change = legLengths(laboratoryAtJoints(), kTarget2) - system.homeDrive();
    samples.states.resize(kLegCount);
    for (const double t : samples.times)
        for (std::size_t i = 0; i < kLegCount; ++i)
            samples.states[i].push_back(
                {system.homeDrive()[static_cast<Eigen::Index>(i)] +
                     0.5 * (1.0 - std::cos(std::numbers::pi * t)) * change[static_cast<Eigen::Index>(i)],
                 0.0, 0.0});
    const TableDrive drive(samples);
    for (const auto& [form, mm] :
         {std::pair{StepForm::Open, 0.1}, {StepForm::Closed, 1e-4}, {StepForm::Corrected, 1e-9}}) {
        const Track track = trackMotion(system, drive, {1000, form, TrackRates::Equations});
        ASSERT_FALSE(track.isSingular);
        const PoseErrors errors = poseErrors(track.rows.back().computed, track.rows.front().exact);
        EXPECT_LT(mmFromMetres(errors.position.norm()), mm) << toWord(form);
    }
}

TEST(Tracking, StopsBeforeAFoldAndSaysWhere) {
    const StepSystem system = shippedSystem("6-ups");
    const LegLengths target = metres(400, 320, 400, 320, 400, 320);
    const Track track =
        trackMotion(system, StraightDrive(system.homeDrive(), target), {500, StepForm::Closed, {}});
    EXPECT_TRUE(track.isSingular);
    EXPECT_LT(track.rows.back().time, 0.9518);
    EXPECT_GT(track.rows.back().time, 0.85);
    EXPECT_GT(track.rows.back().q, 0.0);
    EXPECT_GT(track.smallestSingularValue, 0.0);
    EXPECT_LT(track.smallestSingularValue, 0.2);
}

TEST(Tracking, ADriveThatBeginsElsewhereIsGoneTo) {
    const StepSystem system = shippedSystem("6-ups");
    const LegLengths start = legLengths(laboratoryAtJoints(), kTarget1);
    const Track track =
        trackMotion(system, StraightDrive(start, system.homeDrive()), {100, StepForm::Corrected, {}});
    const PoseErrors errors = poseErrors(track.rows.front().computed, bodyAt(laboratoryAtJoints(), kTarget1));
    EXPECT_LT(errors.position.norm() + errors.turn, 1e-12);
    EXPECT_LT((track.rows.back().computed.p_OP_B - system.mechanism().output.p_OP_home_B).norm(), 1e-10);
}

} // namespace
} // namespace hexapose::testing::tracking_test
