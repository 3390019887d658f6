// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/simulation/fault_injector.h"

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/device/line/line_codec.h"

#include <cmath>
#include <set>

namespace hexapose {

namespace {

constexpr double kLongestSeconds = 1e6;
constexpr double kLargestNoiseMm = 1000.0;

[[noreturn]] void refuse(std::string_view piece, const std::string& cause) {
    throw InputError("--faults", "\"" + std::string(piece) + "\": " + cause);
}

/// A number within [0, max].
double numberUpTo(std::string_view text, double max, std::string_view piece, const std::string& what) {
    const std::optional<double> value = parseNumber(text);
    if (!value || !(*value >= 0.0) || *value > max)
        refuse(piece, what + " must be a number from 0 to " + formatNumber(max));
    return *value;
}

std::chrono::nanoseconds fromSeconds(double seconds) {
    return std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

void readSilence(FaultSpec& spec, std::string_view value, std::string_view piece) {
    const std::size_t at = value.find('@');
    if (at == std::string_view::npos)
        refuse(piece, "silence is SECONDS@AFTER_SECONDS");
    spec.silence = fromSeconds(numberUpTo(value.substr(0, at), kLongestSeconds, piece, "the duration"));
    spec.silenceAfter = fromSeconds(numberUpTo(value.substr(at + 1), kLongestSeconds, piece, "the start"));
}

double* probabilityOf(FaultSpec& spec, std::string_view key) {
    if (key == "crc")
        return &spec.crc;
    if (key == "drop")
        return &spec.drop;
    if (key == "garbage")
        return &spec.garbage;
    if (key == "nan")
        return &spec.nan;
    if (key == "torn")
        return &spec.torn;
    return nullptr;
}

void readPiece(FaultSpec& spec, std::string_view piece, std::set<std::string, std::less<>>& seen) {
    const std::size_t equals = piece.find('=');
    if (equals == std::string_view::npos)
        refuse(piece, "not of the form NAME=VALUE");
    const std::string_view key = piece.substr(0, equals);
    const std::string_view value = piece.substr(equals + 1);
    if (!seen.emplace(key).second)
        refuse(piece, "given twice");
    if (double* probability = probabilityOf(spec, key)) {
        *probability = numberUpTo(value, 1.0, piece, "a probability");
    } else if (key == "silence") {
        readSilence(spec, value, piece);
    } else if (key == "noise") {
        spec.noise = metresFromMm(numberUpTo(value, kLargestNoiseMm, piece, "noise in mm"));
    } else if (key == "seed") {
        const std::optional<long long> seed = parseInteger(value);
        if (!seed || *seed < 0)
            refuse(piece, "a seed is a whole number from 0 up");
        spec.seed = static_cast<std::uint64_t>(*seed);
    } else {
        refuse(piece, "unknown; known are crc, drop, garbage, nan, torn, silence, noise, seed");
    }
}

std::string withWrongChecksum(std::string frame) {
    char& digit = frame[frame.find_last_of('*') + 1];
    digit = digit == '0' ? '1' : '0';
    return frame;
}

/// LEN with one length replaced; every other frame as it is.
std::string withNan(const std::string& frame, std::size_t leg) {
    constexpr std::size_t kCommasBefore = 3;
    if (!frame.starts_with("$LEN,"))
        return frame;
    std::string payload = frame.substr(1, frame.find_last_of('*') - 1);
    std::size_t begin = 0;
    for (std::size_t comma = 0; comma < kCommasBefore + leg; ++comma)
        begin = payload.find(',', begin) + 1;
    payload.replace(begin, payload.find(',', begin) - begin, "nan");
    return line::frame(payload);
}

} // namespace

FaultSpec parseFaultSpec(std::string_view spec) {
    FaultSpec parsed;
    std::set<std::string, std::less<>> seen;
    for (bool more = true; more;) {
        const std::size_t comma = spec.find(',');
        readPiece(parsed, spec.substr(0, comma), seen);
        more = comma != std::string_view::npos;
        if (more)
            spec.remove_prefix(comma + 1);
    }
    return parsed;
}

bool FaultInjector::happens(double probability) {
    return probability > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(m_random) < probability;
}

std::size_t FaultInjector::below(std::size_t bound) {
    return std::uniform_int_distribution<std::size_t>(0, bound - 1)(m_random);
}

std::string FaultInjector::apply(const std::string& frame, std::chrono::nanoseconds now) {
    constexpr std::size_t kMaxGarbage = 64;
    const bool silent = now >= m_spec.silenceAfter && now - m_spec.silenceAfter < m_spec.silence;
    if (silent || happens(m_spec.drop))
        return {};
    std::string out;
    if (happens(m_spec.garbage))
        for (std::size_t left = 1 + below(kMaxGarbage); left > 0; --left)
            out += static_cast<char>(below(256));
    std::string spoilt = happens(m_spec.nan) ? withNan(frame, below(6)) : frame;
    if (happens(m_spec.crc))
        spoilt = withWrongChecksum(spoilt);
    if (happens(m_spec.torn))
        spoilt.resize(1 + below(spoilt.size() - 1));
    return out + spoilt;
}

} // namespace hexapose
