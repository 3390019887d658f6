// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/device/byte_channel.h"
#include "core/device/line/line_codec.h"
#include "core/device/line/line_device.h"
#include "tests/support/exchange.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexapose::testing_support {

/// The other end of a line in memory, with a clock that only reading moves on.
struct Script {
    using Time = std::chrono::steady_clock::time_point;

    Time now{std::chrono::hours(1)};
    std::deque<std::pair<Time, std::string>> incoming;
    std::vector<std::string> sent; ///< payloads
    std::function<void(const std::string& payload)> onSent;
    std::function<void()> onRead; ///< before each wait
    bool lost = false;
    std::size_t unsent = 0;
    int dropped = 0;

    void say(const std::string& payload, std::chrono::milliseconds in = {}) {
        sayBytes(line::frame(payload), in);
    }
    void sayBytes(const std::string& bytes, std::chrono::milliseconds in = {}) {
        incoming.emplace_back(now + in, bytes);
    }
    void len(int n, long long us, char state = 'E', int setNumber = -1, double first = 339.5) {
        say("LEN," + std::to_string(n) + ',' + std::to_string(us) + ',' + std::to_string(first).substr(0, 5) +
            ",336.5,336.6,329.2,345.1,334.5," + state + ',' + std::to_string(setNumber));
    }
    std::vector<std::string> takeSent() { return std::exchange(sent, {}); }
    LineDeviceOptions options() {
        LineDeviceOptions options;
        options.now = [this] { return now; };
        return options;
    }
};

class ScriptedChannel final : public ByteChannel {
public:
    explicit ScriptedChannel(Script& script) : m_script(script) {}

    std::size_t read(std::span<char> buffer, std::chrono::milliseconds wait,
                     const Interruption& interruption) override {
        if (m_script.lost)
            throw ChannelError("unplugged");
        if (m_script.onRead)
            m_script.onRead();
        auto& incoming = m_script.incoming;
        const Script::Time until =
            m_script.now + (interruption.requested() ? std::chrono::milliseconds(0) : wait);
        m_script.now = incoming.empty() ? until : std::clamp(incoming.front().first, m_script.now, until);
        if (incoming.empty() || incoming.front().first > m_script.now)
            return 0;
        std::string& bytes = incoming.front().second;
        const std::size_t count = std::min(buffer.size(), bytes.size());
        std::memcpy(buffer.data(), bytes.data(), count);
        bytes.erase(0, count);
        if (bytes.empty())
            incoming.pop_front();
        return count;
    }
    void write(std::string_view bytes) override {
        if (m_script.lost)
            throw ChannelError("unplugged");
        const std::string payload(bytes.substr(1, bytes.find('*') - 1));
        m_script.sent.push_back(payload);
        if (m_script.onSent)
            m_script.onSent(payload);
    }
    std::size_t unsent() override { return m_script.unsent; }
    void dropUnsent() override { ++m_script.dropped; }

private:
    Script& m_script;
};

/// A line device on a script.
struct Host {
    Script script;
    LineDevice device{std::make_unique<ScriptedChannel>(script), script.options()};

    /// Exchanges until the clock has moved on so far; all notices of that time come with the last feedback.
    DeviceFeedback pass(std::chrono::milliseconds duration, const SetPoints& each = {}) {
        std::vector<DeviceNotice> notices;
        DeviceFeedback feedback;
        for (const auto end = script.now + duration; script.now < end;) {
            feedback = exchange(device, each);
            notices.insert(notices.end(), feedback.notices.begin(), feedback.notices.end());
        }
        feedback.notices = notices;
        return feedback;
    }
    /// Through the handshake, with the answers a controller gives.
    void connect() {
        script.say("IDENT,1,arm,6,20,250,350");
        exchange(device, {});
        script.onSent = [this](const std::string& payload) {
            if (payload == "PERIOD,10")
                script.say("OK,PERIOD");
        };
        exchange(device, {});
        script.onSent = {};
        script.takeSent();
    }
};

inline int count(const std::vector<std::string>& all, const std::string& start) {
    return static_cast<int>(std::count_if(all.begin(), all.end(),
                                          [&](const std::string& one) { return one.starts_with(start); }));
}

template <typename Notice>
int count(const std::vector<DeviceNotice>& all) {
    return static_cast<int>(std::count_if(
        all.begin(), all.end(), [](const DeviceNotice& one) { return std::holds_alternative<Notice>(one); }));
}
/// The first notice of a kind; a default one where there is none.
template <typename Notice>
Notice firstOf(const std::vector<DeviceNotice>& all) {
    for (const DeviceNotice& one : all)
        if (const auto* notice = std::get_if<Notice>(&one))
            return *notice;
    return {};
}

} // namespace hexapose::testing_support
