// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/line/line_codec.h"
#include "core/device/simulation/virtual_platform.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hexapose {

struct LineControllerOptions {
    std::string name = "Hexapose virtual platform"; ///< printable ASCII without commas
    std::chrono::milliseconds period{10};
};

/// The controller's side of the line protocol in front of a virtual platform: bytes in, frames out. Times are
/// the controller's own clock, from 0 up.
class LineController {
public:
    using Clock = std::chrono::nanoseconds;

    LineController(VirtualPlatform platform, LineControllerOptions options = {});

    /// One batch of bytes; a STOP in it beats every SET in it.
    void receive(std::string_view bytes, Clock now);
    /// Moves the legs on to now and reports what is due.
    void step(Clock now);
    /// When step() next has something to report.
    Clock nextDue() const { return m_nextDue; }
    void raiseFault(const std::string& code, const std::string& text);
    /// Whole frames since the last call, oldest first.
    std::vector<std::string> takeFrames();

    const VirtualPlatform& platform() const { return m_platform; }
    void push(int leg, double offset) { m_platform.push(leg, offset); } ///< see VirtualPlatform
    const LinkCounters& counters() const { return m_reader.counters(); }

private:
    void advance(Clock now);
    void report(Clock now);
    void answer(const line::LineMessage& message, bool stopped);
    void set(const line::Set& message, bool stopped);
    void refuse(const line::Malformed& malformed);
    void reply(const std::string& type, VirtualPlatform::Refusal refusal);
    void send(const line::LineMessage& message) { m_frames.push_back(line::encode(message)); }

    VirtualPlatform m_platform;
    LineControllerOptions m_options;
    line::FrameReader m_reader{line::Side::Controller};
    std::vector<line::LineMessage> m_messages;
    std::vector<std::string> m_frames;
    Clock m_now{0};
    Clock m_nextDue;
    std::uint16_t m_frameNumber = 0;
    std::int32_t m_setNumber = -1;
};

} // namespace hexapose
