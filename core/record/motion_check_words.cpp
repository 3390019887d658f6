// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/motion_check_words.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hexapose {

namespace {

using Reason = MotionCheck::Reason;

constexpr std::array<std::string_view, 6> kAxes{"x", "y", "z", "alpha", "beta", "gamma"};

/// Whole words of a reason, or those behind the name of a leg or an axis.
enum class Subject { None, Leg, Axis };
struct ReasonWords {
    Reason reason;
    Subject subject;
    std::string_view words;
};
constexpr std::array<ReasonWords, 14> kReasons{{
    {Reason::Ok, Subject::None, "ok"},
    {Reason::NotFinite, Subject::None, "invalid-input"},
    {Reason::LegAboveMax, Subject::Leg, "above max_mm"},
    {Reason::LegBelowMin, Subject::Leg, "below min_mm"},
    {Reason::NearSingular, Subject::None, "near singular"},
    {Reason::OtherAssemblyMode, Subject::None, "other branch"},
    {Reason::PathNearSingular, Subject::None, "path near singular"},
    {Reason::OutsideEnvelope, Subject::Axis, "outside the envelope"},
    {Reason::WrongSideOfSingularity, Subject::None, "across the singular poses"},
    {Reason::LegSpeed, Subject::Leg, "too fast"},
    {Reason::LegAcceleration, Subject::Leg, "accelerated too hard"},
    {Reason::PlanTooLong, Subject::None, "too long to plan"},
    {Reason::StartMoved, Subject::None, "start moved"},
    {Reason::LimitsChanged, Subject::None, "limits changed"},
}};

constexpr std::array<std::pair<SweepFault, std::string_view>, 4> kSweepFaults{{
    {SweepFault::NoSuchAxis, "sweep: no such axis"},
    {SweepFault::Amplitude, "sweep: the amplitude is not above zero"},
    {SweepFault::Frequency, "sweep: a frequency is below zero"},
    {SweepFault::Duration, "sweep: the duration is not above zero"},
}};

std::string reasonWords(const MotionCheck& check) {
    const auto* entry = std::find_if(kReasons.begin(), kReasons.end(),
                                     [&](const ReasonWords& r) { return r.reason == check.reason; });
    const std::string words(entry->words);
    if (entry->subject == Subject::Leg)
        return "leg " + std::to_string(check.leg) + " " + words;
    if (entry->subject == Subject::Axis && check.axis >= 1 && check.axis <= 6)
        return std::string(kAxes[static_cast<std::size_t>(check.axis - 1)]) + " " + words;
    return words;
}

/// Takes " at 63 %" off the end.
std::optional<double> takePlace(std::string_view& words) {
    constexpr std::string_view kAt = " at ";
    constexpr std::string_view kPercent = " %";
    const std::size_t at = words.rfind(kAt);
    if (at == std::string_view::npos || !words.ends_with(kPercent))
        return std::nullopt;
    const std::string_view number =
        words.substr(at + kAt.size(), words.size() - at - kAt.size() - kPercent.size());
    const std::optional<long long> percent = parseInteger(number);
    if (!percent || *percent < 0 || *percent > 100)
        return std::nullopt;
    words = words.substr(0, at);
    return static_cast<double>(*percent) / 100.0;
}

/// Takes the name of a leg or an axis off the beginning.
Subject takeSubject(std::string_view& words, MotionCheck& check) {
    if (words.size() > 6 && words.starts_with("leg ") && words[4] >= '1' && words[4] <= '6' &&
        words[5] == ' ') {
        check.leg = words[4] - '0';
        words.remove_prefix(6);
        return Subject::Leg;
    }
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        if (!words.starts_with(kAxes[i]) || words.substr(kAxes[i].size(), 1) != " ")
            continue;
        check.axis = static_cast<int>(i) + 1;
        words.remove_prefix(kAxes[i].size() + 1);
        return Subject::Axis;
    }
    return Subject::None;
}

} // namespace

std::string toWords(const MotionCheck& check) {
    if (!check.liesAlongPath())
        return reasonWords(check);
    return reasonWords(check) + " at " + std::to_string(std::lround(100.0 * check.fraction)) + " %";
}

std::optional<MotionCheck> motionCheckFromWords(std::string_view words) {
    MotionCheck check;
    check.value = check.bound = std::numeric_limits<double>::quiet_NaN();
    check.fraction = takePlace(words).value_or(1.0);
    const Subject subject = takeSubject(words, check);
    for (const ReasonWords& entry : kReasons) {
        if (entry.words != words || entry.subject != subject)
            continue;
        check.reason = entry.reason;
        return check;
    }
    return std::nullopt;
}

std::string_view toWords(SweepFault fault) {
    for (const auto& [value, words] : kSweepFaults)
        if (value == fault)
            return words;
    return {};
}

std::optional<SweepFault> sweepFaultFromWords(std::string_view words) {
    for (const auto& [value, known] : kSweepFaults)
        if (known == words)
            return value;
    return std::nullopt;
}

} // namespace hexapose
