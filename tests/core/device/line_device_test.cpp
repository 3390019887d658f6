// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

// What the host's side of the line protocol sends, and when.

#include "core/record/device_words.h"
#include "tests/core/device/scripted_channel.h"
#include "tests/support/exchange.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

namespace hexapose {
namespace {

using namespace std::chrono_literals;
using testing_support::count;
using testing_support::firstOf;
using testing_support::Host;
using Sent = std::vector<std::string>;

const SetPoints kSet{LegLengths::Constant(0.3), DeviceRequest::None};
const std::string kSetLengths = ",300,300,300,300,300,300";

SetPoints request(DeviceRequest request) {
    return {std::nullopt, request};
}

TEST(LineDevice, AsksWhoIsThereUntilItHearsThenForItsPeriod) {
    Host host;
    EXPECT_EQ(host.pass(1000ms, kSet).link, LinkState::Connecting);
    const Sent asked = host.script.takeSent();
    EXPECT_EQ(count(asked, "HELLO,1"), 3); // at 0, 400 and 800 ms
    EXPECT_EQ(asked.size(), 3U);           // and no set-point
    host.script.say("IDENT,1,arm,6,20,250.5,350");
    DeviceFeedback feedback = exchange(host.device, {});
    EXPECT_EQ(feedback.link, LinkState::Connected);
    EXPECT_EQ(feedback.controllerName, "arm");
    EXPECT_EQ(feedback.period, 20ms);
    EXPECT_EQ(feedback.minLength, 0.2505);
    EXPECT_EQ(feedback.maxLength, 0.35);
    EXPECT_EQ(count<notice::Identified>(feedback.notices), 1);
    exchange(host.device, {});
    EXPECT_EQ(host.script.takeSent(), Sent{"PERIOD,10"});
    host.script.say("OK,PERIOD");
    EXPECT_EQ(exchange(host.device, {}).period, 10ms);
    host.pass(500ms);
    EXPECT_EQ(host.script.takeSent(), Sent{});
}

TEST(LineDevice, GoesOnWithTheControllersPeriodWhenItsOwnIsRefusedOrIgnored) {
    Host refused;
    refused.script.say("IDENT,1,arm,6,20,250,350");
    exchange(refused.device, {});
    refused.script.say("ERR,PERIOD,RANGE,20 is all there is", 1ms);
    const DeviceFeedback feedback = exchange(refused.device, {});
    EXPECT_EQ(feedback.link, LinkState::Connected);
    EXPECT_EQ(feedback.period, 20ms);
    ASSERT_EQ(count<notice::Refused>(feedback.notices), 1);
    EXPECT_EQ(firstOf<notice::Refused>(feedback.notices).refusal.text, "RANGE 20 is all there is");
    refused.script.say("IDENT,1,arm,6,20,250,350");
    refused.pass(100ms);
    EXPECT_EQ(count(refused.script.takeSent(), "PERIOD"), 1); // not asked again

    Host ignored;
    ignored.script.say("IDENT,1,arm,6,20,250,350");
    int n = 0;
    std::vector<DeviceNotice> notices;
    for (; n < 400; ++n) {
        ignored.script.len(n, 10000 * n + 1);
        const DeviceFeedback each = ignored.pass(10ms);
        notices.insert(notices.end(), each.notices.begin(), each.notices.end());
    }
    EXPECT_EQ(count(ignored.script.takeSent(), "PERIOD"), 3);
    EXPECT_EQ(count<notice::NoAnswer>(notices), 1);
}

TEST(LineDevice, NumbersItsSetPointsUpAndSendsOnlyThoseThatCanTravel) {
    Host host;
    host.connect();
    for (int i = 0; i < 65537; ++i) {
        host.script.say("OK,X"); // so that no wait is long
        exchange(host.device, kSet);
        const Sent sent = host.script.takeSent();
        ASSERT_EQ(sent, Sent{"SET," + std::to_string(i % 65536) + kSetLengths});
    }
    for (const double bad : {std::nan(""), HUGE_VAL, -0.3, 0.0, 1e9}) {
        SetPoints setPoints = kSet;
        (*setPoints.lengths)[4] = bad;
        EXPECT_EQ(count<notice::Refused>(exchange(host.device, setPoints).notices), 1) << bad;
        EXPECT_EQ(host.script.takeSent(), Sent{}) << bad;
    }
    host.script.unsent = 1000; // a slow line: nothing queues up behind it
    exchange(host.device, kSet);
    EXPECT_EQ(host.script.takeSent(), Sent{});
}

TEST(LineDevice, StopBeatsEverythingAndIsRepeatedUntilConfirmed) {
    for (const bool byState : {true, false}) {
        Host host;
        host.connect();
        host.script.len(0, 1);
        exchange(host.device, {*kSet.lengths, DeviceRequest::Stop});
        EXPECT_EQ(host.script.takeSent(), Sent{"STOP"});
        EXPECT_EQ(host.script.dropped, 1);
        const DeviceFeedback blocked = exchange(host.device, request(DeviceRequest::Enable));
        EXPECT_EQ(count<notice::Refused>(blocked.notices), 1);
        host.pass(285ms, kSet);
        EXPECT_EQ(host.script.takeSent(), (Sent{"STOP", "STOP"})); // no set-point meanwhile
        if (byState)
            host.script.len(1, 2, 'S');
        else
            host.script.say("OK,STOP");
        exchange(host.device, {});
        host.script.takeSent();
        EXPECT_EQ(count<notice::NoAnswer>(host.pass(800ms).notices), 0);
        EXPECT_EQ(host.script.takeSent(), Sent{});
    }
}

TEST(LineDevice, StopIsSentEvenBeforeTheControllerIsKnownAndGivesUpInTheEnd) {
    Host host;
    exchange(host.device, request(DeviceRequest::Stop));
    const DeviceFeedback feedback = host.pass(20s);
    ASSERT_EQ(count<notice::NoAnswer>(feedback.notices), 1);
    EXPECT_EQ(firstOf<notice::NoAnswer>(feedback.notices).request, DeviceRequest::Stop);
    const int stops = count(host.script.takeSent(), "STOP");
    EXPECT_GE(stops, 30);
    EXPECT_LE(stops, 51);
}

TEST(LineDevice, DisableIsRepeatedUntilItIsConfirmed) {
    for (const std::string answer : {"OK,DISABLE", "ERR,DISABLE,STATE,no", "state"}) {
        Host host;
        host.connect();
        host.script.len(0, 1, 'E');
        exchange(host.device, request(DeviceRequest::Disable));
        EXPECT_EQ(host.script.takeSent(), Sent{"DISABLE"});
        host.pass(285ms);
        EXPECT_EQ(host.script.takeSent(), (Sent{"DISABLE", "DISABLE"}));
        if (answer == "state")
            host.script.len(1, 2, 'D');
        else
            host.script.say(answer);
        exchange(host.device, {});
        host.script.takeSent();
        EXPECT_EQ(count<notice::NoAnswer>(host.pass(800ms).notices), 0);
        EXPECT_EQ(count(host.script.takeSent(), "DISABLE"), 0) << answer;
    }
}

TEST(LineDevice, RequestsGoOutOnceAndAMissingAnswerIsTold) {
    const std::pair<DeviceRequest, const char*> rows[] = {{DeviceRequest::Reference, "HOME"},
                                                          {DeviceRequest::Enable, "ENABLE"},
                                                          {DeviceRequest::Disable, "DISABLE"},
                                                          {DeviceRequest::Clear, "CLEAR"}};
    for (const auto& [what, type] : rows) {
        Host host;
        // Drives that may be on are switched off also before the controller said who it is.
        const int refusals = what == DeviceRequest::Disable ? 0 : 1;
        EXPECT_EQ(count<notice::Refused>(exchange(host.device, request(what)).notices), refusals)
            << "not connected yet";
        EXPECT_EQ(count(host.script.takeSent(), type), 1 - refusals);
        host.script.takeSent();
        host.connect();
        exchange(host.device, request(what));
        EXPECT_EQ(host.script.takeSent(), Sent{type});
        EXPECT_EQ(count<notice::NoAnswer>(host.pass(900ms).notices), 0);
        const DeviceFeedback late = host.pass(5s);
        ASSERT_EQ(count<notice::NoAnswer>(late.notices), 1);
        EXPECT_EQ(firstOf<notice::NoAnswer>(late.notices).request, what);
        if (what != DeviceRequest::Disable) { // that one is repeated
            EXPECT_EQ(count(host.script.takeSent(), type), 0);
        }

        host.script.say("OK," + std::string(type), 1ms);
        const DeviceFeedback answered = exchange(host.device, request(what));
        EXPECT_EQ(count<notice::NoAnswer>(host.pass(3s).notices), 0);
        EXPECT_EQ(count<notice::Acknowledged>(answered.notices),
                  what == DeviceRequest::Reference || what == DeviceRequest::Clear ? 1 : 0);
        host.script.say("ERR," + std::string(type) + ",STATE,not now, later", 1ms);
        const DeviceFeedback refused = exchange(host.device, request(what));
        ASSERT_EQ(count<notice::Refused>(refused.notices), 1);
        EXPECT_EQ(firstOf<notice::Refused>(refused.notices).refusal.request, what);
        EXPECT_EQ(firstOf<notice::Refused>(refused.notices).refusal.text, "STATE not now, later");
    }
}

TEST(LineDevice, ASilentControllerGetsNoSetPointsButIsAskedAgain) {
    Host host;
    host.connect();
    host.script.len(0, 1);
    host.pass(5ms);
    EXPECT_EQ(host.pass(10s, kSet).link, LinkState::Connected);
    const Sent sent = host.script.takeSent();
    EXPECT_NEAR(count(sent, "SET"), 1000 / 15, 3);
    EXPECT_NEAR(count(sent, "HELLO"), 9000 / 400, 3);
    host.script.say("IDENT,1,arm,6,10,250,350");
    host.script.len(1000, 10000000);
    const DeviceFeedback back = exchange(host.device, kSet);
    EXPECT_TRUE(back.lengths);
    EXPECT_EQ(back.notices.size(), 0U);
    host.script.takeSent();
    host.pass(100ms, kSet);
    EXPECT_EQ(count(host.script.takeSent(), "SET"), 7);
}

TEST(LineDevice, KeepsTheControllersWatchdogQuietUntilTheStateComesThatSetPointsWaitFor) {
    Host host;
    host.connect();
    exchange(host.device, request(DeviceRequest::Enable));
    host.script.say("OK,ENABLE");
    host.pass(30ms);
    host.script.takeSent();
    host.pass(600ms);
    EXPECT_GE(count(host.script.takeSent(), "HELLO"), 5);
    host.script.len(1, 10000, 'E');
    host.pass(300ms, kSet);
    const Sent sent = host.script.takeSent();
    EXPECT_LE(count(sent, "HELLO"), 1);
    EXPECT_GT(count(sent, "SET"), 10);
}

TEST(LineDevice, AStopThatWaitsEndsTheWaitForAMeasurement) {
    Host host;
    host.connect();
    const auto waited = [&host] {
        const auto begin = host.script.now;
        exchange(host.device, kSet);
        return host.script.now - begin;
    };
    EXPECT_EQ(waited(), 15ms);
    int reads = 0;
    host.script.onRead = [&] {
        if (++reads == 1)
            host.device.interrupt();
    };
    EXPECT_EQ(waited(), 0ms);
    host.script.onRead = {};
    host.device.interrupt();
    EXPECT_EQ(waited(), 0ms);
    EXPECT_EQ(waited(), 15ms) << "one interruption ends one wait";
    host.script.len(1, 10000);
    host.device.interrupt();
    EXPECT_TRUE(exchange(host.device, kSet).lengths) << "what is here is read all the same";
}

TEST(LineDevice, AFaultAndAForeignControllerAreTold) {
    Host host;
    host.script.say("IDENT,2,future,8,10");
    host.script.say("IDENT,2,future,8,10");
    DeviceFeedback feedback = host.pass(50ms, kSet);
    EXPECT_EQ(feedback.link, LinkState::Connecting);
    ASSERT_EQ(count<notice::Refused>(feedback.notices), 1); // once, however often it says so
    EXPECT_EQ(toWords(firstOf<notice::Refused>(feedback.notices).refusal),
              "IDENT not supported: protocol version 2, not 1");
    EXPECT_EQ(feedback.counters.droppedFields, 2U);
    host.script.say("FAULT,7,drive 3, hot");
    feedback = exchange(host.device, {});
    ASSERT_EQ(count<notice::Fault>(feedback.notices), 1);
    EXPECT_EQ(firstOf<notice::Fault>(feedback.notices).text, "7 drive 3, hot");
}

} // namespace
} // namespace hexapose
