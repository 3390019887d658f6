// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/quantities.h"

#include "core/base/csv_table.h"
#include "core/base/number_text.h"
#include "core/base/unit_text.h"
#include "core/base/units.h"
#include "core/base/utc_text.h"
#include "core/record/event_codec.h"

#include <chrono>
#include <cmath>

namespace hexapose {

namespace {

using Value = std::optional<double>;

double milliseconds(std::chrono::nanoseconds duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

Value time(const Snapshot& s) {
    const auto microseconds = std::chrono::duration<double, std::micro>(s.time).count();
    return std::round(microseconds) / 1e6;
}

void wallTime(const Snapshot& s, std::string& line) {
    line += formatUtc(s.wallTime);
}

/// A length or a pose, where the snapshot knows it.
const LegLengths* measuredLengths(const Snapshot& s) {
    return s.fresh && s.measuredLengths ? &*s.measuredLengths : nullptr;
}
const LegLengths* setPoints(const Snapshot& s) {
    return s.commandedLengths ? &*s.commandedLengths : nullptr;
}
const Pose* goal(const Snapshot& s) {
    return s.goalPose ? &*s.goalPose : nullptr;
}
const Pose* measuredPose(const Snapshot& s) {
    return s.fresh && s.measuredPose ? &*s.measuredPose : nullptr;
}
const Pose* path(const Snapshot& s) {
    return s.targetPose ? &*s.targetPose : nullptr;
}

template <const LegLengths* (*kLengths)(const Snapshot&), int kLeg>
Value length(const Snapshot& s) {
    const LegLengths* lengths = kLengths(s);
    return lengths ? Value(mmFromMetres((*lengths)[kLeg])) : std::nullopt;
}
/// From metres, which the text gives back bit for bit.
template <const LegLengths* (*kLengths)(const Snapshot&), int kLeg>
void lengthText(const Snapshot& s, std::string& line) {
    if (const LegLengths* lengths = kLengths(s))
        line += mmText((*lengths)[kLeg]);
}

template <const Pose* (*kPose)(const Snapshot&), int kCoordinate>
Value coordinate(const Snapshot& s) {
    const Pose* pose = kPose(s);
    if (!pose)
        return std::nullopt;
    const double value = pose->toVector()[kCoordinate];
    return kCoordinate < 3 ? mmFromMetres(value) : degFromRadians(value);
}
template <const Pose* (*kPose)(const Snapshot&), int kCoordinate>
void coordinateText(const Snapshot& s, std::string& line) {
    if (const Pose* pose = kPose(s)) {
        const double value = pose->toVector()[kCoordinate];
        line += kCoordinate < 3 ? mmText(value) : degText(value);
    }
}

void status(const Snapshot& s, std::string& line) {
    if (s.fresh)
        line += toWord(s.status);
}
Value iterations(const Snapshot& s) {
    return s.fresh ? Value(s.iterations) : std::nullopt;
}
Value residual(const Snapshot& s) {
    return s.fresh ? Value(mmFromMetres(s.residual)) : std::nullopt;
}
void state(const Snapshot& s, std::string& line) {
    line += toWord(s.state);
}
Value age(const Snapshot& s) {
    return s.measuredLengths ? Value(milliseconds(s.age)) : std::nullopt;
}
Value dropped(const Snapshot& s) {
    return static_cast<double>(s.counters.dropped());
}
void mode(const Snapshot& s, std::string& line) {
    line += toWord(s.mode);
}
Value speed(const Snapshot& s) {
    return 100.0 * s.speed;
}
Value determinantRatio(const Snapshot& s) {
    return s.fresh ? s.determinantRatio : std::nullopt;
}
Value controllerTime(const Snapshot& s) {
    return s.fresh && s.controllerTime ? Value(static_cast<double>(s.controllerTime->count())) : std::nullopt;
}
Value roundTrip(const Snapshot& s) {
    return s.fresh && s.roundTrip ? Value(milliseconds(*s.roundTrip)) : std::nullopt;
}
Value jitter(const Snapshot& s) {
    return s.fresh && s.jitter ? Value(milliseconds(*s.jitter)) : std::nullopt;
}
/// To the nanometre: below that the difference holds the rounding of its two terms alone.
template <int kLeg>
Value followingError(const Snapshot& s) {
    constexpr double kSteps = 1e6; // a millimetre
    if (!s.fresh || !s.measuredLengths || !s.commandedLengths)
        return std::nullopt;
    const double error = mmFromMetres((*s.commandedLengths)[kLeg] - (*s.measuredLengths)[kLeg]);
    return std::round(error * kSteps) / kSteps + 0.0; // no -0
}
void events(const Snapshot& s, std::string& line) {
    if (!s.events.empty())
        line += csvField(formatEvents(s.events));
}

constexpr int kShortest = Quantity::kShortest;

/// Rows of the table that differ in the leg or the coordinate alone.
template <const LegLengths* (*kLengths)(const Snapshot&), int kLeg>
constexpr Quantity leg(std::string_view name, QuantityGroup group) {
    return {name, "mm", group, kShortest, length<kLengths, kLeg>, lengthText<kLengths, kLeg>};
}
template <const Pose* (*kPose)(const Snapshot&), int kCoordinate>
constexpr Quantity axis(std::string_view name, QuantityGroup group) {
    return {name,      kCoordinate < 3 ? "mm" : "deg", group,
            kShortest, coordinate<kPose, kCoordinate>, coordinateText<kPose, kCoordinate>};
}

} // namespace

const std::vector<Quantity>& quantities() {
    using Group = QuantityGroup;
    static const std::vector<Quantity> table{
        {"time_s", "s", Group::Time, 6, time},
        {"time_iso", "", Group::Time, 0, nullptr, wallTime},
        leg<measuredLengths, 0>("l1_mm", Group::Length),
        leg<measuredLengths, 1>("l2_mm", Group::Length),
        leg<measuredLengths, 2>("l3_mm", Group::Length),
        leg<measuredLengths, 3>("l4_mm", Group::Length),
        leg<measuredLengths, 4>("l5_mm", Group::Length),
        leg<measuredLengths, 5>("l6_mm", Group::Length),
        leg<setPoints, 0>("l1_set_mm", Group::SetPoint),
        leg<setPoints, 1>("l2_set_mm", Group::SetPoint),
        leg<setPoints, 2>("l3_set_mm", Group::SetPoint),
        leg<setPoints, 3>("l4_set_mm", Group::SetPoint),
        leg<setPoints, 4>("l5_set_mm", Group::SetPoint),
        leg<setPoints, 5>("l6_set_mm", Group::SetPoint),
        axis<goal, 0>("x_target_mm", Group::Target),
        axis<goal, 1>("y_target_mm", Group::Target),
        axis<goal, 2>("z_target_mm", Group::Target),
        axis<goal, 3>("alpha_target_deg", Group::Target),
        axis<goal, 4>("beta_target_deg", Group::Target),
        axis<goal, 5>("gamma_target_deg", Group::Target),
        axis<measuredPose, 0>("x_mm", Group::Pose),
        axis<measuredPose, 1>("y_mm", Group::Pose),
        axis<measuredPose, 2>("z_mm", Group::Pose),
        axis<measuredPose, 3>("alpha_deg", Group::Pose),
        axis<measuredPose, 4>("beta_deg", Group::Pose),
        axis<measuredPose, 5>("gamma_deg", Group::Pose),
        {"status", "", Group::Solution, 0, nullptr, status},
        {"iterations", "", Group::Solution, 0, iterations},
        {"residual_mm", "mm", Group::Solution, kShortest, residual},
        {"state", "", Group::State, 0, nullptr, state},
        {"age_ms", "ms", Group::Link, 1, age},
        {"dropped", "", Group::Link, 0, dropped},
        axis<path, 0>("x_path_mm", Group::Path),
        axis<path, 1>("y_path_mm", Group::Path),
        axis<path, 2>("z_path_mm", Group::Path),
        axis<path, 3>("alpha_path_deg", Group::Path),
        axis<path, 4>("beta_path_deg", Group::Path),
        axis<path, 5>("gamma_path_deg", Group::Path),
        {"mode", "", Group::Motion, 0, nullptr, mode},
        {"speed_percent", "%", Group::Motion, kShortest, speed},
        {"q", "", Group::Solution, 4, determinantRatio},
        {"controller_time_us", "us", Group::Link, 0, controllerTime},
        {"round_trip_ms", "ms", Group::Link, 3, roundTrip},
        {"jitter_ms", "ms", Group::Link, 3, jitter},
        {"l1_error_mm", "mm", Group::FollowingError, kShortest, followingError<0>},
        {"l2_error_mm", "mm", Group::FollowingError, kShortest, followingError<1>},
        {"l3_error_mm", "mm", Group::FollowingError, kShortest, followingError<2>},
        {"l4_error_mm", "mm", Group::FollowingError, kShortest, followingError<3>},
        {"l5_error_mm", "mm", Group::FollowingError, kShortest, followingError<4>},
        {"l6_error_mm", "mm", Group::FollowingError, kShortest, followingError<5>},
        {"event", "", Group::Event, 0, nullptr, events},
    };
    return table;
}

void Quantity::append(const Snapshot& snapshot, std::string& line) const {
    if (text)
        return text(snapshot, line);
    const std::optional<double> number = value(snapshot);
    if (number && std::isfinite(*number))
        line += decimals == kShortest ? formatNumber(*number) : formatFixed(*number, decimals);
}

} // namespace hexapose
