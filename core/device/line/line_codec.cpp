// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/line_codec.h"

#include <algorithm>
#include <array>

namespace hexapose::line {

namespace {

constexpr std::size_t kTrailerSize = 5;                            ///< '*' and four digits
constexpr std::size_t kMaxBuffer = kMaxPayload + kTrailerSize + 1; ///< and a CR

constexpr std::uint16_t nextCrc(std::uint16_t crc, unsigned char byte) {
    unsigned value = crc ^ (static_cast<unsigned>(byte) << 8U);
    for (int bit = 0; bit < 8; ++bit)
        value = (value & 0x8000U) != 0 ? (value << 1U) ^ 0x1021U : value << 1U;
    return static_cast<std::uint16_t>(value & 0xFFFFU);
}

/// '*' and four digits.
std::array<char, kTrailerSize> trailerOf(std::string_view payload) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    const std::uint32_t crc = crc16(payload);
    std::array<char, kTrailerSize> trailer{'*'};
    for (std::size_t i = 1; i < kTrailerSize; ++i)
        trailer[i] = kDigits[(crc >> (4U * (kTrailerSize - 1 - i))) & 0xFU];
    return trailer;
}

bool isBlank(std::string_view text) {
    return text.find_first_not_of(" \t\r") == std::string_view::npos;
}

std::string_view withoutCarriageReturn(std::string_view text) {
    if (text.ends_with('\r'))
        text.remove_suffix(1);
    return text;
}

} // namespace

std::uint16_t crc16(std::string_view bytes) {
    std::uint16_t crc = 0xFFFF;
    for (const char byte : bytes)
        crc = nextCrc(crc, static_cast<unsigned char>(byte));
    return crc;
}

std::string frame(std::string_view payload) {
    std::string text;
    text.reserve(payload.size() + kTrailerSize + 2);
    text += '$';
    text += payload;
    const std::array trailer = trailerOf(payload);
    text.append(trailer.data(), trailer.size());
    text += '\n';
    return text;
}

std::string encode(const LineMessage& message) {
    return frame(payloadOf(message));
}

FrameReader::FrameReader(Side side) : m_side(side) {
    m_buffer.reserve(kMaxBuffer);
}

void FrameReader::feed(std::string_view bytes, std::vector<LineMessage>& out) {
    for (const char byte : bytes)
        take(byte, out);
}

void FrameReader::noteIdle() {
    if (m_place == Place::Outside && m_buffer.empty())
        m_lineStartKnown = true;
}

void FrameReader::take(char byte, std::vector<LineMessage>& out) {
    if (byte == '$')
        return beginFrame();
    if (byte == '\n') {
        if (m_place == Place::Frame)
            finishFrame(out);
        else if (m_place == Place::Outside)
            finishLine(out);
        m_place = Place::Outside;
        m_lineStartKnown = true;
        return m_buffer.clear();
    }
    if (m_place == Place::Skipping)
        return;
    if (m_buffer.size() < kMaxBuffer) {
        m_buffer += byte;
        return;
    }
    if (m_place == Place::Frame)
        ++m_counters.droppedLength;
    else
        ++m_counters.droppedGarbage;
    m_place = Place::Skipping;
    m_buffer.clear();
}

void FrameReader::beginFrame() {
    if (m_place == Place::Frame)
        ++m_counters.droppedLength; // torn by this one
    else if (m_place == Place::Outside && !isBlank(m_buffer))
        ++m_counters.droppedGarbage;
    m_place = Place::Frame;
    m_buffer.clear();
}

void FrameReader::finishFrame(std::vector<LineMessage>& out) {
    const std::string_view text = withoutCarriageReturn(m_buffer);
    if (text.size() > kMaxPayload + kTrailerSize) {
        ++m_counters.droppedLength;
        return;
    }
    const std::size_t payloadSize = text.size() - std::min(text.size(), kTrailerSize);
    const std::string_view payload = text.substr(0, payloadSize);
    const std::array trailer = trailerOf(payload);
    if (text.substr(payloadSize) != std::string_view(trailer.data(), trailer.size())) {
        ++m_counters.droppedCrc;
        return;
    }
    LineMessage message = parsePayload(payload, m_side);
    if (const auto* malformed = std::get_if<Malformed>(&message)) {
        count(*malformed);
        if (m_side == Side::Controller)
            out.push_back(std::move(message));
        else if (malformed->type == "IDENT") // of no use, but somebody answered
            out.push_back(UnsupportedIdent{RefusalReason::IdentityFields});
        return;
    }
    if (std::holds_alternative<UnsupportedIdent>(message)) {
        ++m_counters.droppedFields;
    } else {
        ++m_counters.accepted;
        m_framedSender = true;
    }
    out.push_back(std::move(message));
}

void FrameReader::finishLine(std::vector<LineMessage>& out) {
    if (isBlank(m_buffer))
        return;
    if (m_side == Side::Host && m_lineStartKnown && !m_framedSender) {
        LineMessage message = parsePlainLine(withoutCarriageReturn(m_buffer));
        if (std::holds_alternative<PlainLengths>(message)) {
            ++m_counters.accepted;
            out.push_back(std::move(message));
            return;
        }
        if (std::get<Malformed>(message).cause == Malformed::Cause::Number) {
            ++m_counters.droppedNumber;
            return;
        }
    }
    ++m_counters.droppedGarbage;
}

void FrameReader::count(const Malformed& malformed) {
    const bool number =
        malformed.cause == Malformed::Cause::Number || malformed.cause == Malformed::Cause::Range;
    ++(number ? m_counters.droppedNumber : m_counters.droppedFields);
}

} // namespace hexapose::line
