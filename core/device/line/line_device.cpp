// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/line_device.h"

#include "core/device/line/line_device_impl.h"

#include <algorithm>
#include <utility>

namespace hexapose {

namespace {

using std::chrono::milliseconds;

constexpr double kLongestLength = 1000.0; ///< m; keeps a SET within a frame
constexpr std::size_t kMaxUnsent = 160;   ///< bytes; two set-points waiting is one too many

bool isEncodable(const LegLengths& lengths) {
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
        pending.sent(DeviceRequest::Stop, time);
        stop.begin(time);
        disable.confirm();
        channel->dropUnsent();
    }
    if (stop.sendsNow(time, options.stopEvery, options.stopGiveUpAfter))
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
    if (identified && periodTries > 0 && !isSilent(time) && !pending.waitsFor(DeviceRequest::Period)) {
        --periodTries;
        write(line::Period{options.desiredPeriod});
        pending.sent(DeviceRequest::Period, time);
    }
}

void LineDevice::Impl::sendRequest(DeviceRequest request, Time time) {
    if (request == DeviceRequest::None && disable.sendsNow(time, options.stopEvery, options.stopGiveUpAfter))
        return write(line::Disable{});
    const std::optional<line::LineMessage> message = line::messageOf(request);
    if (!message || request == DeviceRequest::Stop)
        return;
    // Drives that may be on are switched off also where the controller has not said yet who it is.
    const bool possible = feedback.link == LinkState::Connected ||
                          (request == DeviceRequest::Disable && feedback.link == LinkState::Connecting);
    if (!possible)
        return note(notice::Refused{{request, RefusalReason::NotConnected}});
    if (stop.active() && request != DeviceRequest::Disable)
        return note(notice::Refused{{request, RefusalReason::StopUnconfirmed}});
    write(*message);
    pending.sent(request, time);
    disable.confirm();
    if (request == DeviceRequest::Disable) {
        disable.begin(time);
        disable.sendsNow(time, options.stopEvery, options.stopGiveUpAfter); // it has just been sent
    }
}

void LineDevice::Impl::sendLengths(const LegLengths& lengths, Time time) {
    if (feedback.link != LinkState::Connected || stop.active() || isSilent(time))
        return;
    if (!isEncodable(lengths))
        return note(notice::Refused{{DeviceRequest::SetPoint, RefusalReason::LengthNotPositive}});
    if (channel->unsent() > kMaxUnsent)
        return; // a slow line: the next one is newer
    sentSets[nextSetNumber % sentSets.size()] = SentSet{nextSetNumber, time};
    write(line::Set{nextSetNumber++, lengths});
}

void LineDevice::Impl::receive() {
    const Time deadline = options.now() + options.longestWait;
    for (Time time = options.now();;) {
        const milliseconds left = std::max(std::chrono::ceil<milliseconds>(deadline - time), milliseconds(0));
        const bool ends = interruption.take();
        const bool measured =
            feedback.lengths.has_value(); // then only what is here already: the newest counts
        const std::size_t size =
            channel->read(buffer, measured || ends ? milliseconds(0) : left, interruption);
        time = options.now();
        if (size == 0) {
            if (time - lastByte >= options.pauseOfSender)
                reader.noteIdle();
        } else {
            lastByte = time;
            messages.clear();
            reader.feed({buffer.data(), size}, messages);
            for (const line::LineMessage& message : messages)
                process(message, time);
        }
        if (time >= deadline || ends || (measured && size == 0))
            return;
    }
}

void LineDevice::Impl::reportTimeouts() {
    for (const DeviceRequest request : pending.takeOverdue(options.now(), options.answerWithin))
        if (request != DeviceRequest::Period || periodTries == 0)
            note(notice::NoAnswer{request});
}

void LineDevice::Impl::onLinkLost(const PortFailure& failure) {
    channel.reset();
    feedback.link = LinkState::Lost;
    feedback.lengths.reset();
    feedback.roundTrip.reset();
    note(notice::LinkLost{failure});
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

const DeviceFeedback& LineDevice::read() {
    Impl& device = *m_impl;
    device.feedback.lengths.reset();
    device.feedback.roundTrip.reset();
    if (device.channel) {
        try {
            device.receive();
            device.reportTimeouts();
        } catch (const ChannelError& error) {
            device.onLinkLost(error.failure());
        }
        device.count();
    } else {
        device.interruption.wait(device.options.longestWait); // nothing can happen here any more
    }
    device.feedback.notices.clear();
    std::swap(device.feedback.notices, device.noted);
    return device.feedback;
}

void LineDevice::write(const SetPoints& setPoints) {
    Impl& device = *m_impl;
    if (!device.channel)
        return;
    try {
        device.send(setPoints);
    } catch (const ChannelError& error) {
        device.onLinkLost(error.failure());
    }
}

void LineDevice::interrupt() {
    m_impl->interruption.request();
}

} // namespace hexapose
