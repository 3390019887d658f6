// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// What the host's side makes of the measurements, and of what comes instead of them.

#include "tests/core/device/scripted_channel.h"
#include "tests/support/exchange.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing_support::count;
using testing_support::firstOf;
using testing_support::Host;

const std::string kPlain = "339.5,336.5,336.6,329.2,345.1,334.5\n";

TEST(LineDeviceLink, GivesAMeasurementOnceAndAsItWasSent) {
    Host host;
    host.connect();
    host.script.len(7, 123456, 'D', 65535);
    const auto begin = host.script.now;
    const DeviceFeedback feedback = exchange(host.device, {});
    LegLengths expected;
    expected << 0.3395, 0.3365, 0.3366, 0.3292, 0.3451, 0.3345;
    ASSERT_TRUE(feedback.lengths);
    EXPECT_EQ(*feedback.lengths, expected);
    EXPECT_EQ(feedback.controllerTime, 123456us);
    EXPECT_EQ(feedback.state, ControllerState::Disabled);
    EXPECT_EQ(feedback.acceptedSetPoint, 65535);
    EXPECT_TRUE(feedback.protectedLink);
    EXPECT_EQ(feedback.receivedAt, begin);
    const DeviceFeedback next = exchange(host.device, {});
    EXPECT_FALSE(next.lengths);
    EXPECT_EQ(next.receivedAt, begin);
    EXPECT_EQ(next.state, ControllerState::Disabled);
    EXPECT_EQ(host.script.now, begin + 15ms); // waited no longer than that
}

TEST(LineDeviceLink, MeasuresTheWayOfASetPointThereAndBack) {
    const SetPoints set{LegLengths::Constant(0.3), DeviceRequest::None};
    Host host;
    host.connect();
    host.script.len(1, 1000);
    exchange(host.device, set); // number 0
    EXPECT_FALSE(host.device.read().roundTrip) << "no measurement, no round trip";
    host.script.len(2, 2000, 'E', -1);
    EXPECT_FALSE(exchange(host.device, set).roundTrip) << "number 1 is sent, none confirmed";
    host.script.now += 7ms;
    host.script.len(3, 3000, 'E', 1);
    const DeviceFeedback confirmed = host.device.read();
    ASSERT_TRUE(confirmed.roundTrip);
    EXPECT_EQ(*confirmed.roundTrip, 7ms);
    host.script.len(4, 4000, 'E', 1);
    EXPECT_FALSE(host.device.read().roundTrip) << "confirmed before";
    host.script.len(5, 5000, 'E', 999);
    EXPECT_FALSE(host.device.read().roundTrip) << "never sent";
}

TEST(LineDeviceLink, UsesTheNewestOfAQueueAndCountsWhatIsMissingOrRepeated) {
    Host host;
    host.connect();
    const auto before = exchange(host.device, {}).counters;
    for (const int n : {65533, 65534, 1, 2}) // 65535 and 0 never came
        host.script.len(n, n > 1000 ? n : n + 65536, 'E', -1, 330.0 + n % 10);
    host.script.len(2, 65539, 'E', -1, 300.0); // its number was there
    host.script.len(3, 65538, 'E', -1, 300.0); // its time was there
    host.script.len(4, 65537, 'E', -1, 300.0); // from before
    const DeviceFeedback feedback = exchange(host.device, {});
    ASSERT_TRUE(feedback.lengths);
    EXPECT_NEAR((*feedback.lengths)[0], 0.332, 1e-9);
    EXPECT_EQ(feedback.counters.missed, 2U);
    EXPECT_EQ(feedback.counters.droppedOrder, 3U);
    EXPECT_EQ(feedback.counters.accepted, before.accepted + 4);
    host.script.len(3, 65540);
    EXPECT_TRUE(exchange(host.device, {}).lengths);
}

TEST(LineDeviceLink, SurvivesARestartOfTheControllerButNoStrayOldFrames) {
    Host host;
    host.connect();
    host.script.len(500, 5000000, 'E', 42);
    exchange(host.device, {});
    for (int i = 0; i < 4; ++i) { // old ones, then a new one
        host.script.len(100 + i, 1000 + i);
        EXPECT_FALSE(exchange(host.device, {}).lengths);
    }
    host.script.len(501, 5010000, 'E', 42);
    EXPECT_EQ(exchange(host.device, {}).acceptedSetPoint, 42);
    EXPECT_EQ(host.script.takeSent().size(), 0U);

    DeviceFeedback feedback;
    for (int i = 0; i < 5; ++i) {
        EXPECT_FALSE(feedback.lengths);
        host.script.len(i, 1000 + i, 'U');
        feedback = exchange(host.device, {});
    }
    EXPECT_TRUE(feedback.lengths);
    EXPECT_EQ(feedback.link, LinkState::Connecting);
    EXPECT_EQ(feedback.state, ControllerState::Unreferenced);
    EXPECT_FALSE(feedback.acceptedSetPoint);
    EXPECT_EQ(count<notice::ClockWentBack>(feedback.notices), 1);
    EXPECT_EQ(feedback.counters.droppedOrder, 8U);
    EXPECT_EQ(feedback.counters.missed, 0U);
    host.script.say("IDENT,1,arm,6,20,250,350");
    host.pass(30ms);
    EXPECT_EQ(host.script.takeSent(), (std::vector<std::string>{"HELLO,1", "PERIOD,10"}));
    EXPECT_EQ(exchange(host.device, {}).link, LinkState::Connected);
}

TEST(LineDeviceLink, ARestartedControllerOwesNoAnswerToWhatWasAskedBefore) {
    Host host;
    host.connect();
    host.script.len(500, 5000000, 'D');
    exchange(host.device, {});
    exchange(host.device, {{}, DeviceRequest::Enable});
    for (int i = 0; i < 5; ++i) {
        host.script.len(i, 1000 + i, 'U');
        exchange(host.device, {});
    }
    host.script.say("IDENT,1,arm,6,10,250,350");
    EXPECT_EQ(count<notice::NoAnswer>(host.pass(5s).notices), 0);
}

TEST(LineDeviceLink, BrokenFramesAreCountedAndGiveNothing) {
    Host host;
    host.connect();
    const std::string good = line::frame("LEN,1,1,339.5,336.5,336.6,329.2,345.1,334.5,E,-1");
    for (std::size_t cut = 1; cut < good.size(); ++cut)
        host.script.sayBytes(good.substr(0, cut) + "$");
    host.script.say("LEN,1,1,nan,336.5,336.6,329.2,345.1,334.5,E,-1");
    const DeviceFeedback feedback = host.pass(100ms);
    EXPECT_FALSE(feedback.lengths);
    EXPECT_EQ(feedback.receivedAt, std::chrono::steady_clock::time_point{});
    EXPECT_GE(feedback.counters.dropped(), good.size() - 1);
    EXPECT_EQ(feedback.counters.droppedNumber, 1U);
    host.script.sayBytes(good);
    EXPECT_TRUE(exchange(host.device, {}).lengths);
}

TEST(LineDeviceLink, AFloodOfGarbageDoesNotKeepAnExchange) {
    Host host;
    host.connect();
    for (int i = 0; i < 1000; ++i)
        host.script.sayBytes(std::string(4096, '#'), std::chrono::milliseconds(i));
    const auto begin = host.script.now;
    EXPECT_FALSE(exchange(host.device, {}).lengths);
    EXPECT_LE(host.script.now - begin, 16ms);
}

TEST(LineDeviceLink, ListensToASenderOfBareLinesWithoutCommandingIt) {
    Host host;
    host.script.sayBytes("6.6,329.2,345.1,334.5\n" + kPlain);
    DeviceFeedback feedback = exchange(host.device, {});
    EXPECT_TRUE(feedback.lengths);
    EXPECT_EQ(feedback.link, LinkState::ListenOnly);
    EXPECT_FALSE(feedback.protectedLink);
    EXPECT_EQ(feedback.state, ControllerState::Unknown);
    EXPECT_EQ(count<notice::ListenOnly>(feedback.notices), 1);
    host.script.takeSent();
    for (int i = 0; i < 100; ++i) {
        host.script.sayBytes(kPlain, 10ms);
        feedback = exchange(host.device,
                            {LegLengths::Constant(0.3), i == 50 ? DeviceRequest::Stop : DeviceRequest::None});
        EXPECT_TRUE(feedback.lengths);
        EXPECT_TRUE(feedback.notices.empty());
    }
    EXPECT_TRUE(host.script.takeSent().empty());
    host.script.len(0, 1); // a controller after all
    EXPECT_EQ(exchange(host.device, {}).link, LinkState::Connecting);
    host.script.sayBytes(kPlain);
    const DeviceFeedback late = exchange(host.device, {});
    EXPECT_FALSE(late.lengths);
    EXPECT_EQ(late.counters.droppedGarbage, 2U);
    EXPECT_TRUE(late.protectedLink);
}

TEST(LineDeviceLink, ALoneLineAfterAPauseCounts) {
    Host host;
    host.pass(100ms);
    host.script.sayBytes(kPlain);
    EXPECT_TRUE(exchange(host.device, {}).lengths);
}

TEST(LineDeviceLink, TellsALostPortOnce) {
    Host host;
    host.connect();
    host.script.lost = true;
    DeviceFeedback feedback = exchange(host.device, {LegLengths::Constant(0.3), DeviceRequest::Stop});
    EXPECT_EQ(feedback.link, LinkState::Lost);
    ASSERT_EQ(count<notice::LinkLost>(feedback.notices), 1);
    EXPECT_EQ(firstOf<notice::LinkLost>(feedback.notices).failure.system, "unplugged");
    host.script.lost = false;
    feedback = exchange(host.device, {});
    EXPECT_EQ(feedback.link, LinkState::Lost);
    EXPECT_TRUE(feedback.notices.empty());
}

} // namespace
} // namespace hexapose
