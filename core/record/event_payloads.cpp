// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/event_payloads.h"

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/record/device_words.h"
#include "core/record/motion_check_words.h"

#include <algorithm>
#include <cmath>

namespace hexapose::payload {

namespace {

constexpr std::string_view kStaleData = "stale data";
constexpr std::string_view kNotAnswered = " was not answered";
constexpr std::string_view kRowsLost = " rows lost";
constexpr std::string_view kGigabytes = " GB";
constexpr std::string_view kMinutes = " min";
constexpr std::string_view kDeleted = ": the file before it was deleted";
constexpr std::string_view kMoved = ": the file before it was moved or replaced";
constexpr double kBytesInGigabyte = 1e9;
constexpr std::string_view kIn = " in ";
constexpr std::string_view kOff = " off by ";
constexpr std::string_view kOffPath = " off the path by ";
constexpr std::string_view kLimit = " mm, limit ";
constexpr std::string_view kStalled = " mm, and the path does not go on";
constexpr std::string_view kMm = " mm";
constexpr std::string_view kTo = " to ";
constexpr std::string_view kComma = ", ";

std::string words(std::monostate) {
    return {};
}
std::string words(double value) {
    return formatNumber(value);
}
std::string words(const DeviceText& text) {
    return text.text;
}
std::string words(const PortFailure& failure) {
    return toWords(failure);
}
std::string words(const MotionCheck& check) {
    return toWords(check);
}
std::string words(const MotionInhibit& inhibit) {
    return std::string(inhibit.solver ? toWord(*inhibit.solver) : kStaleData);
}
std::string words(SweepFault fault) {
    return std::string(toWords(fault));
}
std::string words(Command command) {
    return std::string(toWord(command));
}
std::string words(ControllerState state) {
    return std::string(1, toLetter(state));
}
std::string words(SolveStatus status) {
    return std::string(toWord(status));
}
std::string words(const DeviceRefusal& refusal) {
    return toWords(refusal);
}
std::string words(DeviceRequest request) {
    return std::string(toWord(request));
}
std::string words(const CommandRefusal& refusal) {
    return std::string(toWord(refusal.command)).append(kIn).append(toWord(refusal.state));
}
std::string words(const FollowingError& error) {
    const bool path = error.cause != FollowingError::Cause::SetPoint;
    std::string text = "leg " + std::to_string(error.leg);
    text.append(path ? kOffPath : kOff).append(formatFixed(mmFromMetres(error.gap), 2));
    if (error.cause == FollowingError::Cause::Stalled)
        return text.append(kStalled);
    return text.append(kLimit).append(formatFixed(mmFromMetres(error.limit), 1)).append(kMm);
}
std::string words(const PreparationFailure& failure) {
    if (!failure.answered)
        return std::string(toWord(failure.request)).append(kNotAnswered);
    if (failure.refusal)
        return toWords(*failure.refusal);
    return failure.request == DeviceRequest::Reference ? "reference" : "enable";
}
std::string words(const ControllerIdentity& identity) {
    std::string text = identity.name;
    if (identity.minLength && identity.maxLength)
        text.append(kComma)
            .append(formatNumber(mmFromMetres(*identity.minLength)))
            .append(kTo)
            .append(formatNumber(mmFromMetres(*identity.maxLength)))
            .append(kMm);
    return text;
}
std::string words(const SolverChoice& choice) {
    return choice.modelFingerprint.empty() ? choice.name : choice.name + " " + choice.modelFingerprint;
}
std::string words(const LogFailure& failure) {
    return failure.system.empty() ? std::to_string(failure.rowsLost).append(kRowsLost) : failure.system;
}

std::string words(const LogSpace& space) {
    std::string text = formatFixed(static_cast<double>(space.freeBytes) / kBytesInGigabyte, 2);
    text.append(kGigabytes);
    if (space.secondsLeft)
        text.append(kComma).append(formatFixed(*space.secondsLeft / 60.0, 0)).append(kMinutes);
    return text;
}
std::string words(const LogContinuation& continuation) {
    using Cause = LogContinuation::Cause;
    std::string text = continuation.file;
    if (continuation.cause != Cause::Full)
        text.append(continuation.cause == Cause::Deleted ? kDeleted : kMoved);
    return text;
}

// ---------------------------------------------------------------- and back

/// What stands before a piece of text, which is taken off with it; nothing when the piece is not there.
std::optional<std::string_view> takeUpTo(std::string_view& text, std::string_view piece) {
    const std::size_t at = text.find(piece);
    if (at == std::string_view::npos)
        return std::nullopt;
    const std::string_view before = text.substr(0, at);
    text.remove_prefix(at + piece.size());
    return before;
}

bool takeEnd(std::string_view& text, std::string_view end) {
    if (!text.ends_with(end))
        return false;
    text.remove_suffix(end.size());
    return true;
}

std::optional<double> metres(std::string_view mm) {
    const std::optional<double> value = parseNumber(mm);
    return value ? std::optional(metresFromMm(*value)) : std::nullopt;
}

template <typename T>
EventData orText(const std::optional<T>& value, std::string_view text) {
    return value ? EventData(*value) : EventData(DeviceText{std::string(text)});
}

std::optional<Command> commandOf(std::string_view word) {
    const auto* found = std::find_if(kCommands.begin(), kCommands.end(),
                                     [&](Command command) { return toWord(command) == word; });
    return found == kCommands.end() ? std::nullopt : std::optional(*found);
}

std::optional<CommandRefusal> commandRefusal(std::string_view text) {
    const std::optional<std::string_view> word = takeUpTo(text, kIn);
    const std::optional<Command> command = word ? commandOf(*word) : std::nullopt;
    const std::optional<RunState> state = runStateFromWord(text);
    return command && state ? std::optional(CommandRefusal{*command, *state}) : std::nullopt;
}

std::optional<FollowingError> followingError(std::string_view text) {
    if (text.size() < 5 || !text.starts_with("leg ") || text[4] < '1' || text[4] > '6')
        return std::nullopt;
    FollowingError error;
    error.leg = text[4] - '0';
    text.remove_prefix(5);
    const bool path = text.starts_with(kOffPath);
    if (!path && !text.starts_with(kOff))
        return std::nullopt;
    text.remove_prefix(path ? kOffPath.size() : kOff.size());
    if (path && takeEnd(text, kStalled)) {
        error.cause = FollowingError::Cause::Stalled;
        const std::optional<double> gap = metres(text);
        error.gap = gap.value_or(0.0);
        return gap ? std::optional(error) : std::nullopt;
    }
    error.cause = path ? FollowingError::Cause::Path : FollowingError::Cause::SetPoint;
    const std::optional<std::string_view> gapText = takeUpTo(text, kLimit);
    const std::optional<double> gap = gapText ? metres(*gapText) : std::nullopt;
    const std::optional<double> limit = takeEnd(text, kMm) ? metres(text) : std::nullopt;
    error.gap = gap.value_or(0.0);
    error.limit = limit.value_or(0.0);
    return gap && limit ? std::optional(error) : std::nullopt;
}

std::optional<PreparationFailure> preparation(std::string_view text) {
    if (text == "reference" || text == "enable")
        return PreparationFailure{
            text == "enable" ? DeviceRequest::Enable : DeviceRequest::Reference, true, {}};
    std::string_view word = text;
    if (takeEnd(word, kNotAnswered) && deviceRequestFromWord(word) != DeviceRequest::Other)
        return PreparationFailure{deviceRequestFromWord(word), false, {}};
    const DeviceRefusal refusal = deviceRefusalFromWords(text);
    if (refusal.request == DeviceRequest::Other)
        return std::nullopt;
    return PreparationFailure{refusal.request, true, refusal};
}

ControllerIdentity identity(std::string_view text) {
    std::string_view rest = text;
    const std::size_t comma = rest.rfind(kComma);
    if (comma != std::string_view::npos && takeEnd(rest, kMm)) {
        rest.remove_prefix(comma + kComma.size());
        const std::optional<std::string_view> least = takeUpTo(rest, kTo);
        const std::optional<double> min = least ? metres(*least) : std::nullopt;
        const std::optional<double> max = metres(rest);
        if (min && max)
            return {std::string(text.substr(0, comma)), min, max};
    }
    return {std::string(text), {}, {}};
}

SolverChoice solver(std::string_view text) {
    const std::size_t space = std::min(text.find(' '), text.size());
    return {std::string(text.substr(0, space)), std::string(text.substr(std::min(space + 1, text.size())))};
}

std::optional<LogFailure> logFailure(std::string_view text) {
    std::string_view number = text;
    if (!takeEnd(number, kRowsLost))
        return LogFailure{0, std::string(text)};
    const auto count = parseInteger(number);
    if (!count || *count < 0)
        return std::nullopt;
    return LogFailure{static_cast<std::uint64_t>(*count), {}};
}

std::optional<LogSpace> logSpace(std::string_view text) {
    const std::optional<std::string_view> number = takeUpTo(text, kGigabytes);
    const std::optional<double> free = number ? parseNumber(*number) : std::nullopt;
    if (!free || !(*free >= 0.0 && *free < kBytesInGigabyte))
        return std::nullopt;
    LogSpace space{static_cast<std::uint64_t>(std::llround(*free * kBytesInGigabyte)), {}};
    if (text.empty())
        return space;
    if (!text.starts_with(kComma) || !takeEnd(text, kMinutes))
        return std::nullopt;
    const std::optional<double> minutes = parseNumber(text.substr(kComma.size()));
    if (!minutes)
        return std::nullopt;
    space.secondsLeft = 60.0 * *minutes;
    return space;
}

LogContinuation logContinuation(std::string_view text) {
    using Cause = LogContinuation::Cause;
    const Cause cause = takeEnd(text, kDeleted) ? Cause::Deleted
                        : takeEnd(text, kMoved) ? Cause::Moved
                                                : Cause::Full;
    return {cause, std::string(text)};
}

EventData moveRefusal(std::string_view text) {
    if (text == kStaleData)
        return MotionInhibit{};
    if (const auto check = motionCheckFromWords(text))
        return *check;
    if (const auto fault = sweepFaultFromWords(text))
        return *fault;
    if (const auto status = solveStatusFromWord(text))
        return MotionInhibit{status};
    return DeviceText{std::string(text)};
}

} // namespace

std::string toWords(const EventData& data) {
    return std::visit([](const auto& value) { return words(value); }, data);
}

EventData fromWords(Form form, std::string_view text) {
    if (text.empty())
        return {};
    switch (form) {
    case Form::None:
    case Form::Text:
        break;
    case Form::Number:
        return orText(parseNumber(text), text);
    case Form::Port:
        return portFailureFromWords(text);
    case Form::MotionCheck:
        return orText(motionCheckFromWords(text), text);
    case Form::MoveRefusal:
        return moveRefusal(text);
    case Form::Command:
        return orText(commandOf(text), text);
    case Form::ControllerState:
        return orText(text.size() == 1 ? controllerStateFromLetter(text[0]) : std::nullopt, text);
    case Form::SolveStatus:
        return orText(solveStatusFromWord(text), text);
    case Form::Refusal:
        return deviceRefusalFromWords(text);
    case Form::Request: {
        const DeviceRequest request = deviceRequestFromWord(text);
        return request == DeviceRequest::Other ? EventData(DeviceText{std::string(text)})
                                               : EventData(request);
    }
    case Form::CommandRefusal:
        return orText(commandRefusal(text), text);
    case Form::FollowingError:
        return orText(followingError(text), text);
    case Form::Preparation:
        return orText(preparation(text), text);
    case Form::Identity:
        return identity(text);
    case Form::Solver:
        return solver(text);
    case Form::LogFailure:
        return orText(logFailure(text), text);
    case Form::LogSpace:
        return orText(logSpace(text), text);
    case Form::LogContinuation:
        return logContinuation(text);
    }
    return DeviceText{std::string(text)};
}

} // namespace hexapose::payload
