// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/line_device_impl.h"

#include <type_traits>

namespace hexapose {

namespace {

constexpr int kPeriodTries = 3;

} // namespace

void LineDevice::Impl::note(Kind kind, std::string request, std::string text) {
    feedback.notices.push_back({kind, std::move(request), std::move(text)});
}

void LineDevice::Impl::complainOnce(const std::string& request, const std::string& text) {
    if (request + text == lastComplaint)
        return;
    lastComplaint = request + text;
    note(Kind::Refused, request, text);
}

void LineDevice::Impl::take(const line::LineMessage& message, Time time) {
    lastHeard = time;
    const bool plain = std::holds_alternative<line::PlainLengths>(message);
    if (!plain && feedback.link == LinkState::ListenOnly)
        feedback.link = LinkState::Connecting; // a controller after all
    if (const auto* len = std::get_if<line::Len>(&message))
        take(*len, time);
    else if (const auto* lengths = std::get_if<line::PlainLengths>(&message))
        take(*lengths, time);
    else if (const auto* ok = std::get_if<line::Ok>(&message))
        take(*ok);
    else if (const auto* err = std::get_if<line::Err>(&message))
        take(*err);
    else if (const auto* fault = std::get_if<line::Fault>(&message))
        note(Kind::Fault, fault->code, fault->text);
    else if (const auto* ident = std::get_if<line::Ident>(&message))
        take(*ident);
    else if (const auto* unsupported = std::get_if<line::UnsupportedIdent>(&message))
        take(*unsupported);
}

void LineDevice::Impl::take(const line::Ident& ident) {
    const bool isNew = !identified || ident.name != feedback.controllerName;
    identified = true;
    lastComplaint.clear();
    feedback.link = LinkState::Connected;
    feedback.controllerName = ident.name;
    feedback.period = ident.period;
    feedback.minLength = ident.minLength;
    feedback.maxLength = ident.maxLength;
    if (isNew) {
        note(Kind::Identified, {}, ident.name);
        periodRefused = false;
    }
    if (isNew || (ident.period != options.desiredPeriod && !periodRefused))
        periodTries = kPeriodTries;
}

void LineDevice::Impl::take(const line::UnsupportedIdent& ident) {
    complainOnce("IDENT", "not supported: " + ident.cause);
}

void LineDevice::Impl::take(const line::Ok& ok) {
    if (ok.request == "STOP")
        stop.confirm();
    if (ok.request == "DISABLE")
        disable.confirm();
    if (ok.request == "ENABLE")
        awaitsEnabled = true;
    if (ok.request == "HOME")
        note(Kind::Acknowledged, ok.request, {});
    if (pending.answered(ok.request) && ok.request == "PERIOD") {
        feedback.period = options.desiredPeriod;
        periodTries = 0;
    }
}

void LineDevice::Impl::take(const line::Err& err) {
    const std::string text = err.text.empty() ? err.code : err.code + ' ' + err.text;
    if (err.request == "HELLO")
        return complainOnce(err.request, text);
    if (err.request == "STOP") // asked again until it is confirmed
        return complainOnce(err.request, text);
    if (err.request == "DISABLE")
        disable.confirm();
    pending.answered(err.request);
    if (err.request == "PERIOD") {
        periodTries = 0;
        periodRefused = true;
    }
    note(Kind::Refused, err.request, text);
}

void LineDevice::Impl::take(const line::Len& len, Time time) {
    switch (order.judge(len.number, len.time)) {
    case line::FrameSequence::Result::Drop:
        ++droppedOrder;
        return;
    case line::FrameSequence::Result::Restart:
        beginAgain();
        break;
    case line::FrameSequence::Result::Next:
        break;
    }
    awaitsEnabled = false;
    feedback.lengths = len.lengths;
    feedback.receivedAt = time;
    feedback.controllerTime = len.time;
    feedback.protectedLink = true;
    feedback.state = len.state;
    feedback.echoesSetPoints = true;
    feedback.acceptedSetPoint = len.setNumber < 0 ? std::nullopt : std::optional(len.setNumber);
    if (len.state == ControllerState::Disabled && disable.active()) {
        disable.confirm();
        pending.answered("DISABLE");
    }
    if (len.state == ControllerState::Stopped) {
        stop.confirm();
        pending.answered("STOP");
    }
}

void LineDevice::Impl::take(const line::PlainLengths& plain, Time time) {
    if (feedback.link != LinkState::ListenOnly) {
        feedback.link = LinkState::ListenOnly;
        note(Kind::ListenOnly, {}, {});
    }
    feedback.lengths = plain.lengths;
    feedback.receivedAt = time;
    feedback.protectedLink = false;
}

/// The controller started again and knows nothing of what was asked before.
void LineDevice::Impl::beginAgain() {
    note(Kind::ClockWentBack, {}, {});
    identified = false;
    lastHello.reset();
    pending.clear();
    disable.confirm();
    periodTries = 0;
    feedback.link = LinkState::Connecting;
    feedback.period = std::chrono::milliseconds(0);
}

} // namespace hexapose
