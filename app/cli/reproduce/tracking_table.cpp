// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/tracking_table.h"

#include "app/cli/reproduce/printed.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/finite_step/pose_errors.h"
#include "core/geometry/euler_angles.h"

#include <algorithm>
#include <cmath>

namespace hexapose::reproduce {

namespace {

Eigen::Vector3d inDeg(const Eigen::Vector3d& radians) {
    return radians.unaryExpr(&degFromRadians);
}
Eigen::Vector3d inMm(const Eigen::Vector3d& metres) {
    return metres.unaryExpr(&mmFromMetres);
}

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
constexpr std::array<std::size_t, 4> kRates{1, 2, 4, 5}; ///< all but posture and position
/// As in files of poses.
constexpr std::array<const char*, 6> kPoseColumns{"x_mm",      "y_mm",     "z_mm",
                                                  "alpha_deg", "beta_deg", "gamma_deg"};

std::string header(const StepSystem& system) {
    std::string line = "time_s";
    for (const Actuator& actuator : system.mechanism().actuators)
        line += "," + actuator.name + (actuator.kind == ActuatorKind::Crank ? "_deg" : "_mm");
    for (const char* column : kPoseColumns)
        line += std::string(",") + column;
    const auto add = [&line](const std::string& prefix, const TrackQuantity& quantity) {
        for (const char* axis : kAxes)
            line += "," + prefix + quantity.column + "_" + axis + "_" + quantity.ending;
    };
    for (const std::size_t i : kRates)
        add("", kTrackQuantities[i]);
    for (const TrackQuantity& quantity : kTrackQuantities)
        add("error_", quantity);
    return line + ",q,status\n";
}

} // namespace

TrackVectors trackValues(const StepSystem& system, const BodyMotion& body) {
    const EulerAngles angles = eulerAngles(body.R_BP);
    return {inDeg({angles.alpha, angles.beta, angles.gamma}),
            inDeg(body.angularVelocity),
            inDeg(body.angularAcceleration),
            inMm(body.p_OP_B - system.mechanism().output.p_OP_home_B),
            inMm(body.velocity),
            inMm(body.acceleration)};
}

TrackVectors trackErrors(const TrackRow& row) {
    const PoseErrors pose = poseErrors(row.computed, row.exact);
    return {inDeg(pose.posture),
            inDeg(row.computed.angularVelocity - row.exact.angularVelocity),
            inDeg(row.computed.angularAcceleration - row.exact.angularAcceleration),
            inMm(pose.position),
            inMm(row.computed.velocity - row.exact.velocity),
            inMm(row.computed.acceleration - row.exact.acceleration)};
}

std::array<double, 6> largestErrors(const Track& track) {
    std::array<double, 6> largest{};
    for (const TrackRow& row : track.rows) {
        const TrackVectors errors = trackErrors(row);
        for (std::size_t i = 0; i < errors.size(); ++i)
            largest[i] =
                std::max(largest[i], i == 0 ? degFromRadians(poseErrors(row.computed, row.exact).turn)
                                            : errors[i].norm());
    }
    return largest;
}

std::string trackCsv(const StepSystem& system, const Track& track) {
    std::string csv = header(system);
    const auto& actuators = system.mechanism().actuators;
    const auto add = [&csv](const Eigen::Vector3d& values) {
        for (const double value : values)
            csv += "," + (std::isfinite(value) ? formatNumber(value) : std::string());
    };
    for (const TrackRow& row : track.rows) {
        csv += formatNumber(row.time);
        for (std::size_t i = 0; i < actuators.size(); ++i) {
            const double value = row.drive[i].value;
            csv += "," + formatNumber(actuators[i].kind == ActuatorKind::Crank ? degFromRadians(value)
                                                                               : mmFromMetres(value));
        }
        const TrackVectors values = trackValues(system, row.computed), errors = trackErrors(row);
        add(values[3]);
        add(values[0]);
        for (const std::size_t i : kRates)
            add(values[i]);
        for (const Eigen::Vector3d& error : errors)
            add(error);
        const bool stopped = track.isSingular && &row == &track.rows.back();
        csv += "," + formatNumber(row.q) + (stopped ? ",singular\n" : ",ok\n");
    }
    return csv;
}

std::string trackSummary(const Track& track) {
    std::string csv = "quantity,unit,largest_error\n";
    const std::array<double, 6> largest = largestErrors(track);
    for (std::size_t i = 0; i < largest.size(); ++i)
        csv += csvLine({kTrackQuantities[i].column, kTrackQuantities[i].ending, formatNumber(largest[i])});
    return csv;
}

} // namespace hexapose::reproduce
