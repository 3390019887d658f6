// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/line_device_impl.h"

#include "core/device/line/wire_words.h"

#include <type_traits>
#include <utility>
#include <variant>

namespace hexapose {

namespace {

constexpr int kPeriodTries = 3;

} // namespace

/// Reports once what a controller repeats with every HELLO.
void LineDevice::Impl::reportOnce(DeviceRefusal refusal) {
    if (lastReported == refusal)
        return;
    lastReported = refusal;
    note(notice::Refused{std::move(refusal)});
}

void LineDevice::Impl::process(const line::LineMessage& message, Time time) {
    lastHeard = time;
    const bool plain = std::holds_alternative<line::PlainLengths>(message);
    if (!plain && feedback.link == LinkState::ListenOnly)
        feedback.link = LinkState::Connecting; // a controller after all
    const auto take = [&](const auto& m) {
        using Message = std::decay_t<decltype(m)>;
        if constexpr (std::is_same_v<Message, line::Len> || std::is_same_v<Message, line::PlainLengths>)
            process(m, time);
        else if constexpr (std::is_same_v<Message, line::Ident> ||
                           std::is_same_v<Message, line::UnsupportedIdent> ||
                           std::is_same_v<Message, line::Ok> || std::is_same_v<Message, line::Err> ||
                           std::is_same_v<Message, line::Fault>)
            process(m);
    };
    std::visit(take, message);
}

void LineDevice::Impl::process(const line::Ident& ident) {
    const bool isNew = !identified || ident.name != feedback.controllerName;
    identified = true;
    lastReported.reset();
    feedback.link = LinkState::Connected;
    feedback.controllerName = ident.name;
    feedback.period = ident.period;
    feedback.minLength = ident.minLength;
    feedback.maxLength = ident.maxLength;
    if (isNew) {
        note(notice::Identified{ident.name});
        periodRefused = false;
    }
    if (isNew || (ident.period != options.desiredPeriod && !periodRefused))
        periodTries = kPeriodTries;
}

void LineDevice::Impl::process(const line::UnsupportedIdent& ident) {
    reportOnce({DeviceRequest::Identity, ident.reason, {}, ident.number});
}

void LineDevice::Impl::process(const line::Ok& ok) {
    const DeviceRequest request = line::requestOfType(ok.request);
    if (request == DeviceRequest::Stop)
        stop.confirm();
    if (request == DeviceRequest::Disable)
        disable.confirm();
    if (request == DeviceRequest::Enable)
        awaitsEnabled = true;
    if (request == DeviceRequest::Reference || request == DeviceRequest::Clear)
        note(notice::Acknowledged{request});
    if (pending.answered(request) && request == DeviceRequest::Period) {
        feedback.period = options.desiredPeriod;
        periodTries = 0;
    }
}

void LineDevice::Impl::process(const line::Err& err) {
    const DeviceRequest request = line::requestOfType(err.request);
    DeviceRefusal refusal{request, line::reasonOfCode(err.code), err.code};
    if (!err.text.empty())
        refusal.text += ' ' + err.text;
    if (request == DeviceRequest::Other)
        refusal.text = err.request + ' ' + refusal.text;
    if (request == DeviceRequest::Hello ||
        request == DeviceRequest::Stop) // asked again until it is confirmed
        return reportOnce(std::move(refusal));
    if (request == DeviceRequest::Disable)
        disable.confirm();
    pending.answered(request);
    if (request == DeviceRequest::Period) {
        periodTries = 0;
        periodRefused = true;
    }
    note(notice::Refused{std::move(refusal)});
}

void LineDevice::Impl::process(const line::Fault& fault) {
    note(notice::Fault{fault.code + ' ' + fault.text});
}

void LineDevice::Impl::process(const line::Len& len, Time time) {
    switch (order.classify(len.number, len.time)) {
    case line::FrameSequence::Result::Discard:
        ++droppedOrder;
        return;
    case line::FrameSequence::Result::Restart:
        onControllerRestart();
        break;
    case line::FrameSequence::Result::Accept:
        break;
    }
    awaitsEnabled = false;
    feedback.lengths = len.lengths;
    feedback.receivedAt = time;
    feedback.controllerTime = len.time;
    feedback.roundTrip.reset();
    feedback.protectedLink = true;
    feedback.state = len.state;
    feedback.echoesSetPoints = true;
    noteEcho(len.setNumber, time);
    feedback.acceptedSetPoint = len.setNumber < 0 ? std::nullopt : std::optional(len.setNumber);
    if (len.state == ControllerState::Disabled && disable.active()) {
        disable.confirm();
        pending.answered(DeviceRequest::Disable);
    }
    if (len.state == ControllerState::Stopped) {
        stop.confirm();
        pending.answered(DeviceRequest::Stop);
    }
}

/// The first measurement that confirms a set-point ends its way there and back.
void LineDevice::Impl::noteEcho(std::int32_t setNumber, Time time) {
    if (setNumber < 0 || feedback.acceptedSetPoint == setNumber)
        return;
    std::optional<SentSet>& sent = sentSets[static_cast<std::size_t>(setNumber) % sentSets.size()];
    if (sent && sent->number == setNumber)
        feedback.roundTrip = time - sent->time;
    sent.reset();
}

void LineDevice::Impl::process(const line::PlainLengths& plain, Time time) {
    if (feedback.link != LinkState::ListenOnly) {
        feedback.link = LinkState::ListenOnly;
        note(notice::ListenOnly{});
    }
    feedback.lengths = plain.lengths;
    feedback.receivedAt = time;
    feedback.controllerTime.reset();
    feedback.protectedLink = false;
}

/// The controller started again and knows nothing of what was asked before.
void LineDevice::Impl::onControllerRestart() {
    note(notice::ClockWentBack{});
    identified = false;
    lastHello.reset();
    pending.clear();
    disable.confirm();
    periodTries = 0;
    feedback.link = LinkState::Connecting;
    feedback.period = std::chrono::milliseconds(0);
}

} // namespace hexapose
