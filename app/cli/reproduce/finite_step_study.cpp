// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/finite_step_study.h"

#include "app/cli/reproduce/styles.h"
#include "core/base/units.h"
#include "core/finite_step/leg_path.h"
#include "core/kinematics/inverse_kinematics.h"
#include "ui/plot/nice_ticks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace hexapose::reproduce {

namespace {

constexpr int kRepetitions = 3;

Pose inMmDeg(double x, double y, double z, double alpha, double beta, double gamma) {
    return {{metresFromMm(x), metresFromMm(y), metresFromMm(z)},
            {radiansFromDeg(alpha), radiansFromDeg(beta), radiansFromDeg(gamma)}};
}

BodyMotion bodyAt(const PlatformGeometry& platform, const Pose& pose) {
    BodyMotion body;
    body.R_BP = rotationMatrix(pose.angles);
    body.p_OP_B = platform.p_OP_home_B + pose.offset;
    return body;
}

} // namespace

PlatformGeometry atJointCentre(PlatformGeometry platform) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const Leg& leg : platform.legs)
        centre += leg.p_PB_P / kLegCount;
    centre.head<2>().setZero(); // the joints lie about the axis; only the height is another
    platform.p_OP_home_B += centre;
    for (Leg& leg : platform.legs)
        leg.p_PB_P -= centre;
    return platform;
}

Pose nearTarget() {
    return inMmDeg(12, -4, 40, 0, 0, 5);
}
Pose wideTarget() {
    return inMmDeg(30, -20, 35, 20, -15, 25);
}

double StepMeasurement::positionMm() const {
    return mmFromMetres(errors.position.norm());
}
double StepMeasurement::turnDeg() const {
    return degFromRadians(errors.turn);
}

PoseErrors errorsBetween(const PlatformGeometry& platform, const Pose& found, const Pose& truth) {
    return poseErrors(bodyAt(platform, found), bodyAt(platform, truth));
}

StepMeasurement measureSteps(const PlatformGeometry& platform, const Pose& target, StepForm form, int steps) {
    const LegPath path(platform);
    const LegLengths lengths = legLengths(platform, target);
    StepMeasurement measurement{form, steps, {}, std::numeric_limits<double>::infinity()};
    for (int i = 0; i < kRepetitions; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        const PathResult result = path.followStraight(Pose{}, lengths, steps, form);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        measurement.seconds = std::min(measurement.seconds, taken.count());
        measurement.errors = errorsBetween(platform, result.pose, target);
    }
    return measurement;
}

int stepsTo(const PlatformGeometry& platform, const Pose& target, StepForm form, double mm, int most) {
    const LegPath path(platform);
    const LegLengths lengths = legLengths(platform, target);
    const auto isNear = [&](int steps) {
        const PathResult result = path.followStraight(Pose{}, lengths, steps, form);
        return result.end == PathEnd::Reached &&
               mmFromMetres(errorsBetween(platform, result.pose, target).position.norm()) <= mm;
    };
    int high = 1;
    while (high < most && !isNear(high))
        high = std::min(2 * high, most);
    if (!isNear(high))
        return 0;
    int low = high / 2; // not near, or 0
    while (high - low > 1)
        (isNear((low + high) / 2) ? high : low) = (low + high) / 2;
    return high;
}

double orderBetween(const StepMeasurement& coarse, const StepMeasurement& fine) {
    return std::log(coarse.positionMm() / fine.positionMm()) /
           std::log(static_cast<double>(fine.steps) / coarse.steps);
}

std::vector<Plot::Mark> decadeMarks(int first, int last) {
    std::vector<Plot::Mark> marks;
    for (int k = first; k <= last; ++k) {
        const QString power = timesPowerOfTen(k); // "×10⁻⁴"
        marks.push_back({static_cast<double>(k), k == 0 ? QStringLiteral("1") : power.mid(1)});
    }
    return marks;
}

Plot::Series seriesOf(StepForm form) {
    switch (form) {
    case StepForm::Open:
        return {QStringLiteral("open, as the paper"), kBlue, Plot::Marker::Circle, true, {}};
    case StepForm::Closed:
        return {QStringLiteral("closed"), kVermilion, Plot::Marker::Triangle, true, {}};
    case StepForm::Corrected:
        break;
    }
    return {QStringLiteral("corrected"), kGreen, Plot::Marker::Square, true, {}};
}

} // namespace hexapose::reproduce
