// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/line_device.h"

#include "core/device/line/line_device_impl.h"

#include <algorithm>
#include <thread>

namespace hexapose {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPauseOnceLost{10};
constexpr milliseconds kHurryWithin{2};   ///< a wait is cut in pieces of this, to see that it is to end
constexpr double kLongestLength = 1000.0; ///< m; keeps a SET within a frame
constexpr std::size_t kMaxUnsent = 160;   ///< bytes; two set-points waiting is one too many

bool canTravel(const LegLengths& lengths) {
    return lengths.allFinite() && (lengths.array() > 0.0).all() && (lengths.array() < kLongestLength).all();
}

} // namespace

LineDevice::Impl::Impl(std::unique_ptr<ByteChannel> theChannel, LineDeviceOptions theOptions)
    : channel(std::move(theChannel)), options(std::move(theOptions)), lastHeard(options.now()),
      lastByte(lastHeard) {}

void LineDevice::Impl::write(const line::LineMessage& message) {
    channel->write(line::encode(message));
}

void LineDevice::Impl::send(const SetPoints& setPoints) {
    const Time time = options.now();
    sendStop(setPoints.request == DeviceRequest::Stop, time);
    sendHandshake(time);
    sendRequest(setPoints.request, time);
    if (setPoints.lengths)
        sendLengths(*setPoints.lengths, time);
}

void LineDevice::Impl::sendStop(bool asked, Time time) {
    if (asked && feedback.link != LinkState::ListenOnly) {
        pending.clear();
        pending.sent("STOP", time);
        stop.begin(time);
        disable.confirm();
        channel->dropUnsent();
    }
    if (stop.takeDue(time, options.stopEvery, options.stopGiveUpAfter))
        write(line::Stop{});
}

void LineDevice::Impl::sendHandshake(Time time) {
    const bool unknown = !identified && feedback.link != LinkState::ListenOnly;
    const bool due = !lastHello || time - *lastHello >= options.helloEvery;
    // Where measurements are rare the controller's watchdog, of 250 ms, would be faster than the state that
    // we wait for.
    const bool keepsAlive = awaitsEnabled && (!lastHello || time - *lastHello >= options.aliveEvery);
    if (((unknown || isSilent(time)) && due) || keepsAlive) {
        write(line::Hello{});
        lastHello = time;
    }
    if (identified && periodTries > 0 && !isSilent(time) && !pending.waitsFor("PERIOD")) {
        --periodTries;
        write(line::Period{options.desiredPeriod});
        pending.sent("PERIOD", time);
    }
}

void LineDevice::Impl::sendRequest(DeviceRequest request, Time time) {
    if (request == DeviceRequest::None && disable.takeDue(time, options.stopEvery, options.stopGiveUpAfter))
        return write(line::Disable{});
    const std::optional<line::LineMessage> message = line::messageOf(request);
    if (!message || request == DeviceRequest::Stop)
        return;
    const std::string type = line::payloadOf(*message);
    if (feedback.link != LinkState::Connected)
        return note(Kind::Refused, type, "STATE no controller is connected");
    if (stop.active() && request != DeviceRequest::Disable)
        return note(Kind::Refused, type, "STATE the stop is not confirmed yet");
    write(*message);
    pending.sent(type, time);
    disable.confirm();
    if (request == DeviceRequest::Disable) {
        disable.begin(time);
        disable.takeDue(time, options.stopEvery, options.stopGiveUpAfter); // it has just been sent
    }
}

void LineDevice::Impl::sendLengths(const LegLengths& lengths, Time time) {
    if (feedback.link != LinkState::Connected || stop.active() || isSilent(time))
        return;
    if (!canTravel(lengths))
        return note(Kind::Refused, "SET", "RANGE a length is not a positive number");
    if (channel->unsent() > kMaxUnsent)
        return; // a slow line: the next one is newer
    write(line::Set{nextSetNumber++, lengths});
}

void LineDevice::Impl::receive(const std::atomic<bool>* hurry) {
    const Time deadline = options.now() + options.longestWait;
    for (Time time = options.now();;) {
        milliseconds left = std::chrono::ceil<milliseconds>(deadline - time);
        const bool hurries = hurry != nullptr && *hurry;
        if (hurries)
            left = milliseconds(0);
        else if (hurry != nullptr)
            left = std::min(left, kHurryWithin);
        const bool measured =
            feedback.lengths.has_value(); // then only what is here already: the newest counts
        const std::size_t size =
            channel->read(buffer, measured ? milliseconds(0) : std::max(left, milliseconds(0)));
        time = options.now();
        if (size == 0) {
            if (time - lastByte >= options.pauseOfSender)
                reader.noteIdle();
        } else {
            lastByte = time;
            messages.clear();
            reader.feed({buffer.data(), size}, messages);
            for (const line::LineMessage& message : messages)
                take(message, time);
        }
        if (time >= deadline || ((measured || hurries) && size == 0))
            return;
    }
}

void LineDevice::Impl::missAnswers() {
    for (const std::string& type : pending.takeOverdue(options.now(), options.answerWithin))
        if (type != "PERIOD" || periodTries == 0)
            note(Kind::NoAnswer, type, {});
}

void LineDevice::Impl::lose(const std::string& reason) {
    channel.reset();
    feedback.link = LinkState::Lost;
    feedback.lengths.reset();
    note(Kind::LinkLost, {}, reason);
}

void LineDevice::Impl::count() {
    feedback.counters = reader.counters();
    feedback.counters.accepted -= droppedOrder;
    feedback.counters.droppedOrder = droppedOrder;
    feedback.counters.missed = order.missed();
}

LineDevice::LineDevice(std::unique_ptr<ByteChannel> channel, LineDeviceOptions options)
    : m_impl(std::make_unique<Impl>(std::move(channel), std::move(options))) {}

LineDevice::~LineDevice() = default;

DeviceFeedback LineDevice::exchange(const SetPoints& setPoints) {
    Impl& device = *m_impl;
    device.feedback.lengths.reset();
    device.feedback.notices.clear();
    if (!device.channel) {
        std::this_thread::sleep_for(kPauseOnceLost); // nothing can happen here any more
        return device.feedback;
    }
    try {
        device.send(setPoints);
        device.receive(setPoints.hurry);
        device.missAnswers();
    } catch (const ChannelError& error) {
        device.lose(error.what());
    }
    device.count();
    return device.feedback;
}

} // namespace hexapose
