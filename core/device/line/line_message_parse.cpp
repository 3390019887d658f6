// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/units.h"
#include "core/device/line/line_message.h"
#include "core/device/line/wire_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace hexapose::line {

namespace {

using Fields = std::vector<std::string_view>;
using Cause = Malformed::Cause;

constexpr long long kVersion = 1;
constexpr long long kMaxCount = 65535;

Fields split(std::string_view payload) {
    Fields fields;
    for (;;) {
        const std::size_t comma = payload.find(',');
        fields.push_back(payload.substr(0, comma));
        if (comma == std::string_view::npos)
            return fields;
        payload.remove_prefix(comma + 1);
    }
}

/// From a field to the end of the payload, commas and all: texts may hold them.
std::string trailingText(const Fields& fields, std::size_t first) {
    const char* begin = fields[first].data();
    const char* end = fields.back().data() + fields.back().size();
    return {begin, end};
}

Malformed malformed(Cause cause, const Fields& fields) {
    return {cause, std::string(fields.front())};
}

/// Six decimals in mm from a field on, as metres.
std::optional<LegLengths> parseLengths(const Fields& fields, std::size_t first) {
    LegLengths lengths;
    for (int leg = 0; leg < kLegCount; ++leg) {
        const std::optional<double> mm = parseWireDecimal(fields[first + static_cast<std::size_t>(leg)]);
        if (!mm)
            return std::nullopt;
        lengths[leg] = metresFromMm(*mm);
    }
    return lengths;
}

bool isMeasurement(const std::optional<LegLengths>& lengths) {
    return lengths && (lengths->array() > 0.0).all();
}

LineMessage parseHello(const Fields& fields) {
    if (fields.size() != 2)
        return malformed(Cause::Fields, fields);
    const std::optional<long long> version = parseWireInteger(fields[1]);
    if (!version)
        return malformed(Cause::Number, fields);
    if (*version != kVersion)
        return malformed(Cause::Range, fields);
    return Hello{};
}

LineMessage parsePeriod(const Fields& fields) {
    if (fields.size() != 2)
        return malformed(Cause::Fields, fields);
    const std::optional<long long> ms = parseWireInteger(fields[1]);
    if (!ms)
        return malformed(Cause::Number, fields);
    if (*ms < kMinPeriodMs || *ms > kMaxPeriodMs)
        return malformed(Cause::Range, fields);
    return Period{std::chrono::milliseconds(*ms)};
}

LineMessage parseSet(const Fields& fields) {
    if (fields.size() != 2 + kLegCount)
        return malformed(Cause::Fields, fields);
    const std::optional<long long> number = parseWireInteger(fields[1]);
    const std::optional<LegLengths> lengths = parseLengths(fields, 2);
    if (!number || !lengths)
        return malformed(Cause::Number, fields);
    if (*number < 0 || *number > kMaxCount)
        return malformed(Cause::Range, fields);
    return Set{static_cast<std::uint16_t>(*number), *lengths};
}

/// Of a type that has no further fields.
template <class Message>
LineMessage parseBare(const Fields& fields) {
    if (fields.size() != 1)
        return malformed(Cause::Fields, fields);
    return Message{};
}

LineMessage parseIdent(const Fields& fields) {
    constexpr std::size_t kFieldCount = 7;
    if (fields.size() < 2)
        return malformed(Cause::Fields, fields);
    const std::optional<long long> version = parseWireInteger(fields[1]);
    if (version && *version != kVersion)
        return UnsupportedIdent{RefusalReason::ProtocolVersion, *version};
    if (fields.size() != kFieldCount)
        return malformed(Cause::Fields, fields);
    const std::optional<long long> legs = parseWireInteger(fields[3]);
    if (version && legs && *legs != kLegCount)
        return UnsupportedIdent{RefusalReason::LegCount, *legs};
    const std::optional<double> period = parseWireDecimal(fields[4]);
    const std::optional<double> min = parseWireDecimal(fields[5]);
    const std::optional<double> max = parseWireDecimal(fields[6]);
    const bool numbers = version && legs && period && min && max;
    if (!numbers || *period < kMinPeriodMs || *period > kMaxPeriodMs || *min < 0.0 || *min >= *max)
        return malformed(Cause::Number, fields);
    return Ident{std::string(fields[2]), std::chrono::milliseconds(std::llround(*period)), metresFromMm(*min),
                 metresFromMm(*max)};
}

LineMessage parseLen(const Fields& fields) {
    constexpr std::size_t kState = 3 + kLegCount;
    if (fields.size() != kState + 2 || fields[kState].size() != 1)
        return malformed(Cause::Fields, fields);
    const std::optional<ControllerState> state = controllerStateFromLetter(fields[kState].front());
    if (!state || *state == ControllerState::Unknown)
        return malformed(Cause::Fields, fields);
    const std::optional<long long> number = parseWireInteger(fields[1]);
    const std::optional<long long> time = parseWireInteger(fields[2]);
    const std::optional<LegLengths> lengths = parseLengths(fields, 3);
    const std::optional<long long> set = parseWireInteger(fields[kState + 1]);
    if (!number || *number < 0 || *number > kMaxCount || !time || *time < 0 || !isMeasurement(lengths) ||
        !set || *set < -1 || *set > kMaxCount)
        return malformed(Cause::Number, fields);
    return Len{static_cast<std::uint16_t>(*number), std::chrono::microseconds(*time), *lengths, *state,
               static_cast<std::int32_t>(*set)};
}

LineMessage parseOk(const Fields& fields) {
    if (fields.size() != 2)
        return malformed(Cause::Fields, fields);
    return Ok{std::string(fields[1])};
}

LineMessage parseErr(const Fields& fields) {
    if (fields.size() < 4)
        return malformed(Cause::Fields, fields);
    return Err{std::string(fields[1]), std::string(fields[2]), trailingText(fields, 3)};
}

LineMessage parseFault(const Fields& fields) {
    if (fields.size() < 3)
        return malformed(Cause::Fields, fields);
    return Fault{std::string(fields[1]), trailingText(fields, 2)};
}

struct Grammar {
    std::string_view type;
    Side reader;
    LineMessage (*parse)(const Fields&);
};

constexpr std::array kGrammar{
    Grammar{"LEN", Side::Host, parseLen},
    Grammar{"OK", Side::Host, parseOk},
    Grammar{"ERR", Side::Host, parseErr},
    Grammar{"FAULT", Side::Host, parseFault},
    Grammar{"IDENT", Side::Host, parseIdent},
    Grammar{"SET", Side::Controller, parseSet},
    Grammar{"STOP", Side::Controller, parseBare<Stop>},
    Grammar{"HELLO", Side::Controller, parseHello},
    Grammar{"PERIOD", Side::Controller, parsePeriod},
    Grammar{"HOME", Side::Controller, parseBare<Home>},
    Grammar{"ENABLE", Side::Controller, parseBare<Enable>},
    Grammar{"DISABLE", Side::Controller, parseBare<Disable>},
    Grammar{"CLEAR", Side::Controller, parseBare<Clear>},
};

bool isPrintableAscii(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

} // namespace

LineMessage parsePayload(std::string_view payload, Side reader) {
    if (!isPrintableAscii(payload))
        return Malformed{Cause::Fields, {}};
    const Fields fields = split(payload);
    for (const Grammar& grammar : kGrammar)
        if (grammar.reader == reader && grammar.type == fields.front())
            return grammar.parse(fields);
    return malformed(Cause::UnknownType, fields);
}

LineMessage parsePlainLine(std::string_view line) {
    constexpr std::string_view kBlanks = " \t";
    constexpr std::string_view kMarks = ",;";
    LegLengths lengths;
    for (int leg = 0; leg < kLegCount; ++leg) {
        line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
        if (leg > 0 && !line.empty() && kMarks.find(line.front()) != std::string_view::npos) {
            line.remove_prefix(1);
            line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
        }
        const std::size_t end = std::min(line.find_first_of(" \t,;"), line.size());
        const std::optional<double> mm = parseWireDecimal(line.substr(0, end));
        if (!mm)
            return Malformed{};
        lengths[leg] = metresFromMm(*mm);
        line.remove_prefix(end);
    }
    if (line.find_first_not_of(kBlanks) != std::string_view::npos)
        return Malformed{};
    if (!isMeasurement(lengths))
        return Malformed{Cause::Number, {}};
    return PlainLengths{lengths};
}

} // namespace hexapose::line
