// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/device_words.h"

#include "core/base/number_text.h"

#include <array>
#include <utility>

namespace hexapose {

namespace {

constexpr std::array<std::pair<DeviceRequest, std::string_view>, 9> kRequests{{
    {DeviceRequest::Reference, "HOME"},
    {DeviceRequest::Enable, "ENABLE"},
    {DeviceRequest::Disable, "DISABLE"},
    {DeviceRequest::Stop, "STOP"},
    {DeviceRequest::Clear, "CLEAR"},
    {DeviceRequest::SetPoint, "SET"},
    {DeviceRequest::Period, "PERIOD"},
    {DeviceRequest::Hello, "HELLO"},
    {DeviceRequest::Identity, "IDENT"},
}};

constexpr std::array<std::pair<RefusalReason, std::string_view>, 3> kCodes{{
    {RefusalReason::State, "STATE"},
    {RefusalReason::Range, "RANGE"},
    {RefusalReason::Format, "FORMAT"},
}};

/// Where the host refused by itself.
constexpr std::array<std::pair<RefusalReason, std::string_view>, 4> kOwnReasons{{
    {RefusalReason::NotConnected, "STATE no controller is connected"},
    {RefusalReason::StopUnconfirmed, "STATE the stop is not confirmed yet"},
    {RefusalReason::LengthNotPositive, "RANGE a length is not a positive number"},
    {RefusalReason::IdentityFields, "not supported: a field is not of its form, or out of range"},
}};

/// Before and after the number that the controller gave.
struct Unsupported {
    RefusalReason reason;
    std::string_view before, after;
};
constexpr std::array<Unsupported, 2> kUnsupported{{
    {RefusalReason::ProtocolVersion, "not supported: protocol version ", ", not 1"},
    {RefusalReason::LegCount, "not supported: ", " legs, not 6"},
}};

/// What follows the path; the system's words, where there are any, stand between the two.
struct PortWords {
    PortFailure::Kind kind;
    std::string_view before, after;
};
constexpr std::array<PortWords, 8> kPorts{{
    {PortFailure::Kind::NotAPort, "not a serial port", ""},
    {PortFailure::Kind::NoPermission,
     "no permission. Add yourself to the group of serial ports (sudo usermod -aG dialout $USER), then log in "
     "again",
     ""},
    {PortFailure::Kind::Busy, "another program has it open (", ")"},
    {PortFailure::Kind::NotOpened, "not opened as a serial port: ", ""},
    {PortFailure::Kind::Gone, "the port is gone", ""},
    {PortFailure::Kind::NotTaking, "the port takes no bytes", ""},
    {PortFailure::Kind::Closed, "the port is closed", ""},
    {PortFailure::Kind::NotFound, "No such file or directory", ""},
}};

std::string ownWords(const DeviceRefusal& refusal) {
    for (const auto& [reason, words] : kOwnReasons)
        if (reason == refusal.reason)
            return std::string(words);
    for (const Unsupported& entry : kUnsupported)
        if (entry.reason == refusal.reason)
            return std::string(entry.before) + std::to_string(refusal.number) + std::string(entry.after);
    return refusal.text;
}

/// Why a controller refused, from the code that its words begin with.
RefusalReason refusalReasonFromCode(std::string_view code) {
    for (const auto& [reason, known] : kCodes)
        if (known == code)
            return reason;
    return RefusalReason::Other;
}

/// What stands between the two, where the text has both.
std::optional<std::string_view> between(std::string_view text, std::string_view before,
                                        std::string_view after) {
    if (!text.starts_with(before) || !text.ends_with(after) || text.size() < before.size() + after.size())
        return std::nullopt;
    return text.substr(before.size(), text.size() - before.size() - after.size());
}

} // namespace

std::string_view toWord(DeviceRequest request) {
    for (const auto& [value, word] : kRequests)
        if (value == request)
            return word;
    return {};
}

DeviceRequest deviceRequestFromWord(std::string_view word) {
    for (const auto& [value, known] : kRequests)
        if (known == word)
            return value;
    return DeviceRequest::Other;
}

std::string toWords(const DeviceRefusal& refusal) {
    const std::string_view request = toWord(refusal.request);
    return request.empty() ? ownWords(refusal) : std::string(request) + " " + ownWords(refusal);
}

DeviceRefusal deviceRefusalFromWords(std::string_view words) {
    const std::size_t end = words.find(' ');
    DeviceRefusal refusal;
    refusal.request = deviceRequestFromWord(words.substr(0, end));
    if (refusal.request == DeviceRequest::Other || end == std::string_view::npos)
        return {DeviceRequest::Other, RefusalReason::Other, std::string(words)};
    const std::string_view text = words.substr(end + 1);
    for (const auto& [reason, known] : kOwnReasons)
        if (known == text)
            return {refusal.request, reason};
    for (const Unsupported& entry : kUnsupported) {
        const auto number = between(text, entry.before, entry.after);
        if (const auto value = number ? parseInteger(*number) : std::nullopt)
            return {refusal.request, entry.reason, {}, *value};
    }
    refusal.reason = refusalReasonFromCode(text.substr(0, text.find(' ')));
    refusal.text = text;
    return refusal;
}

std::string toWords(const PortFailure& failure) {
    const std::string path = failure.path.empty() ? std::string() : failure.path + ": ";
    for (const PortWords& entry : kPorts)
        if (entry.kind == failure.kind)
            return path + std::string(entry.before) + failure.system + std::string(entry.after);
    return path + failure.system;
}

PortFailure portFailureFromWords(std::string_view words) {
    constexpr std::string_view kColon = ": ";
    const std::size_t colon = words.find(kColon);
    if (colon == std::string_view::npos || !words.starts_with('/'))
        return {PortFailure::Kind::Other, {}, std::string(words)};
    PortFailure failure{PortFailure::Kind::Other, std::string(words.substr(0, colon)), {}};
    const std::string_view rest = words.substr(colon + kColon.size());
    for (const PortWords& entry : kPorts) {
        const bool takesSystem = entry.before.ends_with('(') || entry.before.ends_with(' ');
        const auto system = between(rest, entry.before, entry.after);
        if (!system || (!takesSystem && !system->empty()))
            continue;
        failure.kind = entry.kind;
        failure.system = *system;
        return failure;
    }
    failure.system = rest;
    return failure;
}

} // namespace hexapose
