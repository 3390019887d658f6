// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/event_codec.h"

#include "core/base/number_text.h"
#include "core/record/event_payloads.h"

#include <algorithm>
#include <array>

namespace hexapose {

namespace {

using payload::Form;

struct EventWord {
    EventCode code;
    std::string_view word;
    Form form = Form::None;
};

constexpr std::array<EventWord, 39> kEventWords{{
    {EventCode::Connected, "connected", Form::Text},
    {EventCode::ListenOnly, "listen-only"},
    {EventCode::LinkLost, "link-lost", Form::Port},
    {EventCode::DataStale, "data-stale", Form::Number},
    {EventCode::DataFresh, "data-fresh"},
    {EventCode::Referencing, "referencing"},
    {EventCode::Referenced, "referenced"},
    {EventCode::Enabled, "enabled"},
    {EventCode::Disabled, "disabled"},
    {EventCode::MoveStarted, "move-started", Form::Number},
    {EventCode::MoveRefused, "move-refused", Form::MoveRefusal},
    {EventCode::Settled, "settled", Form::Number},
    {EventCode::NotSettled, "not-settled", Form::Number},
    {EventCode::StopRequested, "stop-requested", Form::Command},
    {EventCode::StoppedByController, "stopped-by-controller", Form::ControllerState},
    {EventCode::StoppedOnStaleData, "stopped-on-stale-data"},
    {EventCode::StoppedOnSolver, "stopped-on-solver", Form::SolveStatus},
    {EventCode::StoppedOnRefusal, "stopped-on-refusal", Form::Refusal},
    {EventCode::Cleared, "cleared"},
    {EventCode::ControllerRefused, "controller-refused", Form::Refusal},
    {EventCode::ControllerFault, "controller-fault", Form::Text},
    {EventCode::NoAnswer, "no-answer", Form::Request},
    {EventCode::ClockWentBack, "clock-went-back"},
    {EventCode::CommandRefused, "command-refused", Form::CommandRefusal},
    {EventCode::ReportSample, "report-sample", Form::Number},
    {EventCode::LogFailed, "log-failed", Form::LogFailure},
    {EventCode::LoopFailed, "loop-failed", Form::Text},
    {EventCode::PreparationFailed, "preparation-failed", Form::Preparation},
    {EventCode::StoppedOnFollowingError, "stopped-on-following-error", Form::FollowingError},
    {EventCode::StoppedOnNoEcho, "stopped-on-no-echo", Form::Number},
    {EventCode::StoppedOnLimits, "stopped-on-limits", Form::MotionCheck},
    {EventCode::StoppedOnNewIdentity, "stopped-on-new-identity", Form::Identity},
    {EventCode::StoppedAfterLoss, "stopped-after-loss"},
    {EventCode::DisableUnconfirmed, "disable-unconfirmed"},
    {EventCode::JogStarted, "jog-started"},
    {EventCode::JogLimited, "jog-limited", Form::MotionCheck},
    {EventCode::SolverChanged, "solver-changed", Form::Solver},
    {EventCode::LogSpaceLow, "log-space-low", Form::LogSpace},
    {EventCode::LogContinued, "log-continued", Form::LogContinuation},
}};
// One word for every code, in the order of the codes: a code without its word does not compile.
static_assert([] {
    for (std::size_t i = 0; i < kEventWords.size(); ++i)
        if (static_cast<std::size_t>(kEventWords[i].code) != i)
            return false;
    return static_cast<std::size_t>(EventCode::LogContinued) + 1 == kEventWords.size();
}());

constexpr std::string_view kSeparator = "; ";

} // namespace

std::size_t eventCodeCount() {
    return kEventWords.size();
}

std::string_view toWord(EventCode code) {
    const auto index = static_cast<std::size_t>(code);
    return index < kEventWords.size() ? kEventWords[index].word : "unknown";
}

std::optional<EventCode> eventCodeFromWord(std::string_view word) {
    const auto* found = std::find_if(kEventWords.begin(), kEventWords.end(),
                                     [&](const EventWord& w) { return w.word == word; });
    return found == kEventWords.end() ? std::nullopt : std::optional(found->code);
}

std::string payloadWords(const Event& event) {
    std::string words = payload::toWords(event.data);
    // A payload may come from a controller; a row of the log stays one line whatever it says.
    std::replace_if(
        words.begin(), words.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return words;
}

std::string formatEvent(const Event& event) {
    std::string text(toWord(event.code));
    if (const std::string words = payloadWords(event); !words.empty())
        text += ' ' + words;
    return text;
}

std::optional<Event> parseEvent(std::string_view text) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::optional<EventCode> code = eventCodeFromWord(text.substr(0, end));
    if (!code)
        return std::nullopt;
    const std::string_view words = text.substr(std::min(end + 1, text.size()));
    return Event{*code, payload::fromWords(kEventWords[static_cast<std::size_t>(*code)].form, words)};
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
    std::vector<std::string> texts;
    while (!field.empty()) {
        const std::size_t end = std::min(field.find(kSeparator), field.size());
        const std::string_view piece = field.substr(0, end);
        field.remove_prefix(std::min(end + kSeparator.size(), field.size()));
        if (eventCodeFromWord(piece.substr(0, piece.find(' '))))
            texts.emplace_back(piece);
        else if (!texts.empty())
            texts.back().append(kSeparator).append(piece);
    }
    std::vector<Event> events;
    events.reserve(texts.size());
    for (const std::string& text : texts)
        events.push_back(*parseEvent(text));
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
