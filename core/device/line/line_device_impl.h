// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/interruption.h"
#include "core/device/line/frame_sequence.h"
#include "core/device/line/line_codec.h"
#include "core/device/line/line_device.h"
#include "core/device/line/line_requests.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hexapose {

struct LineDevice::Impl {
    using Time = std::chrono::steady_clock::time_point;

    Impl(std::unique_ptr<ByteChannel> theChannel, LineDeviceOptions theOptions);

    // line_device.cpp: what goes out, and the wait.
    void send(const SetPoints& setPoints);
    void sendStop(bool asked, Time time);
    void sendHandshake(Time time);
    void sendRequest(DeviceRequest request, Time time);
    void sendLengths(const LegLengths& lengths, Time time);
    void write(const line::LineMessage& message);
    void receive();
    void reportTimeouts();
    void onLinkLost(const PortFailure& failure);
    void count();

    // line_device_messages.cpp: what comes in.
    void process(const line::LineMessage& message, Time time);
    void process(const line::Ident& ident);
    void process(const line::UnsupportedIdent& ident);
    void process(const line::Len& len, Time time);
    void process(const line::PlainLengths& plain, Time time);
    void process(const line::Ok& ok);
    void process(const line::Err& err);
    void process(const line::Fault& fault);
    void noteEcho(std::int32_t setNumber, Time time);
    void onControllerRestart();
    void reportOnce(DeviceRefusal refusal);
    template <class Notice>
    void note(Notice notice) {
        noted.emplace_back(std::move(notice));
    }

    bool isSilent(Time time) const {
        return time - lastHeard > std::max(options.silentAfter, 3 * feedback.period);
    }

    std::unique_ptr<ByteChannel> channel; ///< none once the port is lost
    LineDeviceOptions options;
    line::FrameReader reader{line::Side::Host};
    line::FrameSequence order;
    line::PendingRequests pending;
    line::Repeater stop;
    line::Repeater disable;
    DeviceFeedback feedback;
    std::optional<Time> lastHello;
    Time lastHeard; ///< last good frame or line
    Time lastByte;
    bool identified = false;
    bool awaitsEnabled = false; ///< ENABLE was taken; set-points wait for the measurement that reports it
    bool periodRefused = false;
    int periodTries = 0; ///< left
    std::uint16_t nextSetNumber = 0;
    struct SentSet {
        std::uint16_t number;
        Time time;
    };
    std::array<std::optional<SentSet>, 256> sentSets; ///< the latest, by their numbers
    std::uint64_t droppedOrder = 0;
    std::optional<DeviceRefusal> lastReported; ///< of the handshake, which is repeated: reported once
    std::vector<DeviceNotice> noted;           ///< for the next read
    Interruption interruption;
    std::vector<line::LineMessage> messages;
    std::array<char, 4096> buffer{};
};

} // namespace hexapose
