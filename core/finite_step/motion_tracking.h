// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/drive_path.h"
#include "core/finite_step/rigid_fit.h"
#include "core/finite_step/step_form.h"
#include "core/finite_step/step_system.h"

#include <cstdint>
#include <vector>

namespace hexapose {

/// Where velocity and acceleration come from. Equations: the first and second derivative of the step
/// equations, at the computed nodes. Averages: differences of the steps, as the paper has them (section 7); a
/// step's average belongs to its end. The velocity given at the beginning is no average of a step, and a
/// difference from it would be wrong by half the acceleration or more, with any number of steps: the first
/// acceleration is that between the first two steps.
enum class TrackRates : std::uint8_t { Equations, Averages };

struct TrackOptions {
    int steps = 1000;
    StepForm form = StepForm::Closed;
    TrackRates rates = TrackRates::Equations;
};

/// The platform at one step, computed and exact. Exact: Newton's iteration on the constraints, and the
/// equations' derivatives there; NaN where it does not come to rest.
struct TrackRow {
    double time = 0.0;
    double q = 0.0; ///< of the step matrix
    BodyMotion computed, exact;
    std::vector<DriveState> drive;
};

struct Track {
    std::vector<TrackRow> rows;         ///< of every step from 0 on, up to the last or to the stop
    bool isSingular = false;            ///< it stopped before its end; the last row is the pose reached
    double smallestSingularValue = 0.0; ///< of the step matrix at the last row
};

/// The motion of the output over a drive (section 7). Where the drive does not begin at home it is gone to
/// first. Throws InputError when that fails.
Track trackMotion(const StepSystem& system, const DrivePath& drive, const TrackOptions& options);

} // namespace hexapose
