// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/finite_step/motion_tracking.h"

#include <array>
#include <string>
#include <vector>

namespace hexapose::reproduce {

/// The six quantities of a tracked motion, in the order of the paper's Figure 16, each with x, y and z.
struct TrackQuantity {
    const char* title;  ///< "angular velocity"
    const char* column; ///< "angular_velocity"
    const char* unit;   ///< "deg/s"
    const char* ending; ///< of columns: "deg_per_s"
};
inline constexpr std::array<TrackQuantity, 6> kTrackQuantities{
    {{"posture", "posture", "deg", "deg"},
     {"angular velocity", "angular_velocity", "deg/s", "deg_per_s"},
     {"angular acceleration", "angular_acceleration", "deg/s²", "deg_per_s2"},
     {"position", "position", "mm", "mm"},
     {"velocity", "velocity", "mm/s", "mm_per_s"},
     {"acceleration", "acceleration", "mm/s²", "mm_per_s2"}}};

/// Of one row, in the units above. Values: of the output; its posture as alpha, beta, gamma, its position as
/// the offset from home. Errors: computed minus exact; of the posture the angles between the axes (the
/// paper's error model), which have no sign.
using TrackVectors = std::array<Eigen::Vector3d, 6>;
TrackVectors trackValues(const StepSystem& system, const BodyMotion& body);
TrackVectors trackErrors(const TrackRow& row);

/// Largest value of each quantity's Euclidean norm, over all rows; of the posture the angle of the rotation.
std::array<double, 6> largestErrors(const Track& track);

/// One row a step: time, actuators, values, errors, q, status (ok, or singular in the last row).
std::string trackCsv(const StepSystem& system, const Track& track);
/// quantity, unit, largest error.
std::string trackSummary(const Track& track);

} // namespace hexapose::reproduce
