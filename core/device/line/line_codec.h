// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/line/line_message.h"
#include "core/device/platform_device.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose::line {

/// CRC-16/CCITT-FALSE: polynomial 0x1021, initial 0xFFFF, nothing reflected, no final exclusive or.
std::uint16_t crc16(std::string_view bytes);

/// '$' payload '*' CRC LF.
std::string frame(std::string_view payload);

/// The whole frame of a message.
std::string encode(const LineMessage& message);

/// Bytes in, messages out. How the stream is cut into pieces makes no difference. Needs the same memory
/// whatever arrives.
class FrameReader {
public:
    explicit FrameReader(Side side);

    /// Appends what the bytes complete. A Malformed message comes only to the controller's side, which
    /// answers it.
    void feed(std::string_view bytes, std::vector<LineMessage>& out);

    /// The sender has paused: the next byte begins a line. Before the first line end or pause a bare line may
    /// be the tail of a longer one, with its first digits lost, so it is not taken.
    void noteIdle();

    /// accepted and the dropped counters, except droppedOrder.
    const LinkCounters& counters() const { return m_counters; }

private:
    enum class Place { Outside, Frame, Skipping };

    void take(char byte, std::vector<LineMessage>& out);
    void beginFrame();
    void finishFrame(std::vector<LineMessage>& out);
    void finishLine(std::vector<LineMessage>& out);
    void count(const Malformed& malformed);

    Side m_side;
    Place m_place = Place::Outside;
    bool m_lineStartKnown = false;
    bool m_framedSender = false; ///< a good frame was seen: bare lines are garbage from here on
    std::string m_buffer;
    LinkCounters m_counters;
};

} // namespace hexapose::line
