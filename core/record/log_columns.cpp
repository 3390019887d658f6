// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/log_columns.h"
#include "core/record/event_codec.h"

#include "core/base/csv_table.h"
#include "core/base/number_text.h"
#include "core/base/unit_text.h"
#include "core/base/units.h"
#include "core/base/utc_text.h"

#include <chrono>
#include <cmath>

namespace hexapose {

namespace {

void appendTime(const Snapshot& s, std::string& line) {
    const auto microseconds = std::chrono::duration<double, std::micro>(s.time).count();
    line += formatFixed(std::round(microseconds) / 1e6, 6);
}

void appendWallTime(const Snapshot& s, std::string& line) {
    line += formatUtc(s.wallTime);
}

template <int kLeg>
void appendMeasuredLength(const Snapshot& s, std::string& line) {
    if (s.fresh && s.measuredLengths)
        line += mmText((*s.measuredLengths)[kLeg]);
}

template <int kLeg>
void appendCommandedLength(const Snapshot& s, std::string& line) {
    if (s.commandedLengths)
        line += mmText((*s.commandedLengths)[kLeg]);
}

template <int kCoordinate>
void appendCoordinate(const Pose& pose, std::string& line) {
    const double value = pose.toVector()[kCoordinate];
    line += kCoordinate < 3 ? mmText(value) : degText(value);
}

template <int kCoordinate>
void appendGoal(const Snapshot& s, std::string& line) {
    if (s.goalPose)
        appendCoordinate<kCoordinate>(*s.goalPose, line);
}

template <int kCoordinate>
void appendMeasured(const Snapshot& s, std::string& line) {
    if (s.fresh && s.measuredPose)
        appendCoordinate<kCoordinate>(*s.measuredPose, line);
}

template <int kCoordinate>
void appendPath(const Snapshot& s, std::string& line) {
    if (s.targetPose)
        appendCoordinate<kCoordinate>(*s.targetPose, line);
}

void appendMode(const Snapshot& s, std::string& line) {
    line += toWord(s.mode);
}

void appendSpeed(const Snapshot& s, std::string& line) {
    line += formatNumber(100.0 * s.speed);
}

void appendDeterminantRatio(const Snapshot& s, std::string& line) {
    if (s.fresh && s.determinantRatio)
        line += formatFixed(*s.determinantRatio, 4);
}

void appendStatus(const Snapshot& s, std::string& line) {
    if (s.fresh)
        line += toWord(s.status);
}

void appendIterations(const Snapshot& s, std::string& line) {
    if (s.fresh)
        line += std::to_string(s.iterations);
}

void appendResidual(const Snapshot& s, std::string& line) {
    if (s.fresh && std::isfinite(s.residual))
        line += formatNumber(mmFromMetres(s.residual));
}

void appendState(const Snapshot& s, std::string& line) {
    line += toWord(s.state);
}

void appendAge(const Snapshot& s, std::string& line) {
    if (s.measuredLengths)
        line += formatFixed(std::chrono::duration<double, std::milli>(s.age).count(), 1);
}

void appendDropped(const Snapshot& s, std::string& line) {
    line += std::to_string(s.counters.dropped());
}

void appendEvents(const Snapshot& s, std::string& line) {
    if (!s.events.empty())
        line += csvField(formatEvents(s.events));
}

} // namespace

const std::vector<LogColumn>& logColumns() {
    static const std::vector<LogColumn> columns{
        {"time_s", appendTime},
        {"time_iso", appendWallTime},
        {"l1_mm", appendMeasuredLength<0>},
        {"l2_mm", appendMeasuredLength<1>},
        {"l3_mm", appendMeasuredLength<2>},
        {"l4_mm", appendMeasuredLength<3>},
        {"l5_mm", appendMeasuredLength<4>},
        {"l6_mm", appendMeasuredLength<5>},
        {"l1_set_mm", appendCommandedLength<0>},
        {"l2_set_mm", appendCommandedLength<1>},
        {"l3_set_mm", appendCommandedLength<2>},
        {"l4_set_mm", appendCommandedLength<3>},
        {"l5_set_mm", appendCommandedLength<4>},
        {"l6_set_mm", appendCommandedLength<5>},
        {"x_target_mm", appendGoal<0>},
        {"y_target_mm", appendGoal<1>},
        {"z_target_mm", appendGoal<2>},
        {"alpha_target_deg", appendGoal<3>},
        {"beta_target_deg", appendGoal<4>},
        {"gamma_target_deg", appendGoal<5>},
        {"x_mm", appendMeasured<0>},
        {"y_mm", appendMeasured<1>},
        {"z_mm", appendMeasured<2>},
        {"alpha_deg", appendMeasured<3>},
        {"beta_deg", appendMeasured<4>},
        {"gamma_deg", appendMeasured<5>},
        {"status", appendStatus},
        {"iterations", appendIterations},
        {"residual_mm", appendResidual},
        {"state", appendState},
        {"age_ms", appendAge},
        {"dropped", appendDropped},
        {"x_path_mm", appendPath<0>},
        {"y_path_mm", appendPath<1>},
        {"z_path_mm", appendPath<2>},
        {"alpha_path_deg", appendPath<3>},
        {"beta_path_deg", appendPath<4>},
        {"gamma_path_deg", appendPath<5>},
        {"mode", appendMode},
        {"speed_percent", appendSpeed},
        {"q", appendDeterminantRatio},
        {"event", appendEvents},
    };
    return columns;
}

std::string logHeader() {
    std::string line;
    for (const LogColumn& column : logColumns()) {
        line += column.name;
        line += ',';
    }
    line.back() = '\n';
    return line;
}

void appendLogRow(const Snapshot& snapshot, std::string& buffer) {
    for (const LogColumn& column : logColumns()) {
        column.append(snapshot, buffer);
        buffer += ',';
    }
    buffer.back() = '\n';
}

} // namespace hexapose
