// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/reconnecting_device.h"

#include "core/device/byte_channel.h"
#include "tests/support/exchange.h"

#include <gtest/gtest.h>

#include <vector>

namespace hexapose {
namespace {

using namespace std::chrono_literals;

/// Measures a few times, then is lost.
class ShortLived final : public PlatformDevice {
public:
    explicit ShortLived(std::vector<DeviceRequest>& seen) : m_seen(seen) {}
    void write(const SetPoints& setPoints) override { m_seen.push_back(setPoints.request); }
    const DeviceFeedback& read() override {
        m_feedback.link = m_left-- > 0 ? LinkState::Connected : LinkState::Lost;
        m_feedback.notices.clear();
        if (m_feedback.link == LinkState::Lost)
            m_feedback.notices.push_back(notice::LinkLost{{PortFailure::Kind::Other, {}, "unplugged"}});
        else
            m_feedback.receivedAt = std::chrono::steady_clock::now();
        m_feedback.counters.droppedCrc = ++m_dropped;
        return m_feedback;
    }
    void interrupt() override {}

private:
    std::vector<DeviceRequest>& m_seen;
    DeviceFeedback m_feedback;
    int m_left = 2;
    std::uint64_t m_dropped = 0;
};

TEST(ReconnectingDevice, OpensAgainAndTellsEachLossOnce) {
    std::vector<DeviceRequest> seen;
    int opened = 0;
    ReconnectingDevice device(
        [&]() -> std::unique_ptr<PlatformDevice> {
            ++opened;
            if (opened == 3 || opened == 4)
                throw ChannelError("no such port");
            return std::make_unique<ShortLived>(seen);
        },
        0ms);
    std::string links;
    std::vector<std::string> notices;
    std::vector<std::uint64_t> dropped;
    for (int i = 0; i < 11; ++i) {
        const DeviceFeedback feedback =
            exchange(device, {std::nullopt, i == 7 ? DeviceRequest::Stop : DeviceRequest::None});
        links += feedback.link == LinkState::Lost ? 'L' : 'C';
        dropped.push_back(feedback.counters.dropped());
        for (const DeviceNotice& notice : feedback.notices)
            notices.push_back(std::to_string(i) + std::get<notice::LinkLost>(notice).failure.system);
        EXPECT_NE(feedback.receivedAt, std::chrono::steady_clock::time_point{}); // kept over a loss
    }
    EXPECT_EQ(links, "CCLCCLLLCCL");
    EXPECT_EQ(notices, (std::vector<std::string>{"2unplugged", "5unplugged", "10unplugged"}));
    EXPECT_EQ(dropped, (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6, 6, 6, 7, 8, 9}));
    // What was asked for while there was no port is not made up for.
    EXPECT_EQ(seen, std::vector<DeviceRequest>(6, DeviceRequest::None));
}

TEST(ReconnectingDevice, TellsAFirstOpeningThatFailsOnce) {
    int opened = 0;
    ReconnectingDevice device(
        [&]() -> std::unique_ptr<PlatformDevice> {
            ++opened;
            throw ChannelError("no permission");
        },
        0ms);
    const DeviceFeedback first = exchange(device, {});
    EXPECT_EQ(first.link, LinkState::Lost);
    ASSERT_EQ(first.notices.size(), 1U);
    EXPECT_EQ(std::get<notice::LinkLost>(first.notices[0]).failure.system, "no permission");
    EXPECT_TRUE(exchange(device, {}).notices.empty());
    EXPECT_EQ(opened, 2);
    ReconnectingDevice patient(
        [&]() -> std::unique_ptr<PlatformDevice> { throw ChannelError(std::to_string(++opened)); }, 1h);
    exchange(patient, {});
    exchange(patient, {});
    EXPECT_EQ(opened, 3);
}

} // namespace
} // namespace hexapose
