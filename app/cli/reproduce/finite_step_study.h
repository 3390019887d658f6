// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/finite_step/pose_errors.h"
#include "core/finite_step/step_form.h"
#include "core/geometry/platform_geometry.h"
#include "core/geometry/pose.h"
#include "ui/plot/plot.h"

#include <array>
#include <span>
#include <vector>

namespace hexapose::reproduce {

/// The laboratory platform as the second paper has it: the output point in the middle of the platform joints.
PlatformGeometry atJointCentre(PlatformGeometry platform);

/// The targets of the study. The paper draws its own at random and does not print them.
Pose nearTarget(); ///< 12 -4 40 mm, 0 0 5 deg: the attitude of the first paper's physical test
Pose wideTarget(); ///< 30 -20 35 mm, 20 -15 25 deg

inline constexpr std::array<StepForm, 3> kStepForms{StepForm::Open, StepForm::Closed, StepForm::Corrected};

/// What a straight leg path from home to a target comes to.
struct StepMeasurement {
    StepForm form = StepForm::Open;
    int steps = 0;
    PoseErrors errors{};
    double seconds = 0.0; ///< shortest of some repetitions

    double positionMm() const;
    double turnDeg() const;
};
StepMeasurement measureSteps(const PlatformGeometry& platform, const Pose& target, StepForm form, int steps);
PoseErrors errorsBetween(const PlatformGeometry& platform, const Pose& found, const Pose& truth);

/// Fewest steps with which the position error is at most `mm`; 0 where `most` steps do not do.
int stepsTo(const PlatformGeometry& platform, const Pose& target, StepForm form, double mm, int most);

/// Measured order: slope of log error over log steps between two measurements, by position.
double orderBetween(const StepMeasurement& coarse, const StepMeasurement& fine);

/// A logarithmic axis: marks at whole powers of ten.
std::vector<Plot::Mark> decadeMarks(int first, int last);
/// How each form is drawn.
Plot::Series seriesOf(StepForm form);

} // namespace hexapose::reproduce
