// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/event.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>

namespace hexapose {

namespace {

struct EventWord {
    EventCode code;
    std::string_view word;
    bool carriesValue = false;
};

constexpr std::array<EventWord, 37> kEventWords{{
    {EventCode::Connected, "connected"},
    {EventCode::ListenOnly, "listen-only"},
    {EventCode::LinkLost, "link-lost"},
    {EventCode::DataStale, "data-stale", true},
    {EventCode::DataFresh, "data-fresh"},
    {EventCode::Referencing, "referencing"},
    {EventCode::Referenced, "referenced"},
    {EventCode::Enabled, "enabled"},
    {EventCode::Disabled, "disabled"},
    {EventCode::MoveStarted, "move-started", true},
    {EventCode::MoveRefused, "move-refused"},
    {EventCode::Settled, "settled", true},
    {EventCode::NotSettled, "not-settled", true},
    {EventCode::StopRequested, "stop-requested"},
    {EventCode::StoppedByController, "stopped-by-controller"},
    {EventCode::StoppedOnStaleData, "stopped-on-stale-data"},
    {EventCode::StoppedOnSolver, "stopped-on-solver"},
    {EventCode::StoppedOnRefusal, "stopped-on-refusal"},
    {EventCode::Cleared, "cleared"},
    {EventCode::ControllerRefused, "controller-refused"},
    {EventCode::ControllerFault, "controller-fault"},
    {EventCode::NoAnswer, "no-answer"},
    {EventCode::ClockWentBack, "clock-went-back"},
    {EventCode::CommandRefused, "command-refused"},
    {EventCode::ReportSample, "report-sample", true},
    {EventCode::LogFailed, "log-failed"},
    {EventCode::LoopFailed, "loop-failed"},
    {EventCode::PreparationFailed, "preparation-failed"},
    {EventCode::StoppedOnFollowingError, "stopped-on-following-error"},
    {EventCode::StoppedOnNoEcho, "stopped-on-no-echo", true},
    {EventCode::StoppedOnLimits, "stopped-on-limits"},
    {EventCode::StoppedOnNewIdentity, "stopped-on-new-identity"},
    {EventCode::StoppedAfterLoss, "stopped-after-loss"},
    {EventCode::DisableUnconfirmed, "disable-unconfirmed"},
    {EventCode::JogStarted, "jog-started"},
    {EventCode::JogLimited, "jog-limited"},
    {EventCode::SolverChanged, "solver-changed"},
}};
// One word for every code, in the order of the codes: a code without its word does not compile.
static_assert([] {
    for (std::size_t i = 0; i < kEventWords.size(); ++i)
        if (static_cast<std::size_t>(kEventWords[i].code) != i)
            return false;
    return static_cast<std::size_t>(EventCode::SolverChanged) + 1 == kEventWords.size();
}());

constexpr std::string_view kSeparator = "; ";

std::string_view takeToken(std::string_view& text) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view token = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return token;
}

/// One event of a field; nothing when it does not begin with a known word.
std::optional<Event> parseEvent(std::string_view text) {
    const std::optional<EventCode> code = eventCodeFromWord(takeToken(text));
    if (!code)
        return std::nullopt;
    Event event{*code, 0.0, {}};
    if (kEventWords[static_cast<std::size_t>(*code)].carriesValue) {
        std::string_view rest = text;
        if (const std::optional<double> value = parseNumber(takeToken(rest))) {
            event.value = *value;
            text = rest;
        }
    }
    event.detail = text;
    return event;
}

} // namespace

std::string_view toWord(EventCode code) {
    const auto index = static_cast<std::size_t>(code);
    return index < kEventWords.size() ? kEventWords[index].word : "unknown";
}

std::optional<EventCode> eventCodeFromWord(std::string_view word) {
    const auto* found = std::find_if(kEventWords.begin(), kEventWords.end(),
                                     [&](const EventWord& w) { return w.word == word; });
    return found == kEventWords.end() ? std::nullopt : std::optional(found->code);
}

std::string formatEvent(const Event& event) {
    std::string text(toWord(event.code));
    const auto index = static_cast<std::size_t>(event.code);
    if (index < kEventWords.size() && kEventWords[index].carriesValue)
        text += ' ' + formatNumber(event.value);
    if (!event.detail.empty()) {
        text += ' ' + event.detail;
        // A detail may come from a controller; a row of the log stays one line whatever it says.
        std::replace_if(
            text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    }
    return text;
}

std::string formatEvents(const std::vector<Event>& events) {
    std::string field;
    for (const Event& event : events) {
        if (!field.empty())
            field += kSeparator;
        field += formatEvent(event);
    }
    return field;
}

std::vector<Event> parseEvents(std::string_view field) {
    std::vector<Event> events;
    while (!field.empty()) {
        const std::size_t end = std::min(field.find(kSeparator), field.size());
        const std::string_view piece = field.substr(0, end);
        field.remove_prefix(std::min(end + kSeparator.size(), field.size()));
        if (std::optional<Event> event = parseEvent(piece))
            events.push_back(std::move(*event));
        else if (!events.empty())
            events.back().detail.append(kSeparator).append(piece);
    }
    return events;
}

bool isFault(EventCode code) {
    switch (code) {
    case EventCode::LinkLost:
    case EventCode::StoppedByController:
    case EventCode::StoppedOnStaleData:
    case EventCode::StoppedOnSolver:
    case EventCode::StoppedOnRefusal:
    case EventCode::StoppedOnFollowingError:
    case EventCode::StoppedOnNoEcho:
    case EventCode::StoppedOnLimits:
    case EventCode::StoppedOnNewIdentity:
    case EventCode::StoppedAfterLoss:
    case EventCode::ControllerFault:
    case EventCode::ClockWentBack:
    case EventCode::LoopFailed:
        return true;
    default:
        return false;
    }
}

} // namespace hexapose
