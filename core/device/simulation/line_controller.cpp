// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/simulation/line_controller.h"

#include <algorithm>
#include <utility>

namespace hexapose {

namespace {

constexpr int kLateFrames = 10; ///< a process that stood still longer leaves the rest out

using Refusal = VirtualPlatform::Refusal;

bool isStop(const line::LineMessage& message) {
    return std::holds_alternative<line::Stop>(message);
}

} // namespace

LineController::LineController(VirtualPlatform platform, LineControllerOptions options)
    : m_platform(std::move(platform)), m_options(std::move(options)), m_nextDue(m_options.period) {}

void LineController::receive(std::string_view bytes, Clock now) {
    advance(now);
    m_messages.clear();
    m_reader.feed(bytes, m_messages);
    const bool stopped = std::any_of(m_messages.begin(), m_messages.end(), isStop);
    for (const line::LineMessage& message : m_messages)
        answer(message, stopped);
}

void LineController::step(Clock now) {
    if (now - m_nextDue > kLateFrames * m_options.period)
        m_nextDue = now;
    while (m_nextDue <= now) {
        advance(m_nextDue);
        report(m_nextDue);
        m_nextDue += m_options.period;
    }
    advance(now);
}

void LineController::advance(Clock now) {
    if (now <= m_now)
        return;
    m_platform.step(now - m_now);
    m_now = now;
}

void LineController::report(Clock now) {
    send(line::Len{m_frameNumber++, std::chrono::duration_cast<std::chrono::microseconds>(now),
                   m_platform.measure(), m_platform.state(), m_setNumber});
}

void LineController::raiseFault(const std::string& code, const std::string& text) {
    m_platform.fail();
    send(line::Fault{code, text});
}

std::vector<std::string> LineController::takeFrames() {
    return std::exchange(m_frames, {});
}

void LineController::answer(const line::LineMessage& message, bool stopped) {
    if (const auto* malformed = std::get_if<line::Malformed>(&message))
        return refuse(*malformed);
    m_platform.feedWatchdog();
    if (const auto* setPoint = std::get_if<line::Set>(&message))
        return set(*setPoint, stopped);
    if (const auto* period = std::get_if<line::Period>(&message)) {
        m_options.period = period->period;
        m_nextDue = m_now + m_options.period;
        return reply("PERIOD", Refusal::None);
    }
    const std::string type = line::payloadOf(message);
    if (isStop(message)) {
        m_platform.stop();
        reply(type, Refusal::None);
    } else if (std::holds_alternative<line::Home>(message)) {
        reply(type, m_platform.reference());
    } else if (std::holds_alternative<line::Enable>(message)) {
        reply(type, m_platform.enable());
    } else if (std::holds_alternative<line::Disable>(message)) {
        reply(type, m_platform.disable());
    } else if (std::holds_alternative<line::Clear>(message)) {
        m_platform.clear();
        reply(type, Refusal::None);
    } else if (std::holds_alternative<line::Hello>(message)) {
        send(line::Ident{m_options.name, m_options.period, m_platform.shortestStroke(),
                         m_platform.longestStroke()});
    }
}

void LineController::set(const line::Set& message, bool stopped) {
    const Refusal refusal = stopped ? Refusal::State : m_platform.set(message.lengths);
    if (refusal == Refusal::None)
        m_setNumber = message.number;
    else
        reply("SET", refusal);
}

void LineController::reply(const std::string& type, Refusal refusal) {
    switch (refusal) {
    case Refusal::None:
        return send(line::Ok{type});
    case Refusal::State:
        return send(
            line::Err{type, "STATE", std::string("not allowed in state ") + toLetter(m_platform.state())});
    case Refusal::Range:
        return send(line::Err{type, "RANGE", "a length is outside its leg's stroke"});
    }
}

void LineController::refuse(const line::Malformed& malformed) {
    constexpr std::size_t kLongestType = 32;
    const std::string type = malformed.type.substr(0, kLongestType);
    switch (malformed.cause) {
    case line::Malformed::Cause::UnknownType:
        return send(line::Err{type, "UNKNOWN", "no such message"});
    case line::Malformed::Cause::Fields:
        return send(line::Err{type, "FORMAT", "wrong number of fields"});
    case line::Malformed::Cause::Number:
        return send(line::Err{type, "FORMAT", "a number is not of the protocol's form"});
    case line::Malformed::Cause::Range:
        return send(line::Err{type, "RANGE", "outside what this controller takes"});
    }
}

} // namespace hexapose
