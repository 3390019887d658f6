// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/simulation/line_controller.h"

#include "tests/core/device/test_platform.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace std::chrono_literals;

struct Bench {
    LineController controller{VirtualPlatform(testing_support::testPlatform()), {"bench", 10ms}};
    std::chrono::nanoseconds now{0};

    /// Sends payloads in one batch and gives the answers.
    std::vector<std::string> ask(std::initializer_list<std::string> payloads) {
        std::string bytes;
        for (const std::string& payload : payloads)
            bytes += line::frame(payload);
        controller.receive(bytes, now);
        return answers();
    }
    std::vector<std::string> answers() {
        std::vector<std::string> all;
        for (const std::string& frame : controller.takeFrames())
            all.push_back(frame.substr(1, frame.find('*') - 1));
        return all;
    }
    std::vector<std::string> wait(std::chrono::nanoseconds duration) {
        now += duration;
        controller.step(now);
        return answers();
    }
    void enable() {
        ask({"HOME"});
        wait(10ms);
        ask({"ENABLE"});
    }
    char state() const { return toLetter(controller.platform().state()); }
};

using Answers = std::vector<std::string>;

const std::string kTargets = ",250,250,250,250,250,250";

TEST(LineController, AnswersEachRequestAsTheProtocolSays) {
    Bench bench;
    EXPECT_EQ(bench.ask({"HELLO,1"}), Answers{"IDENT,1,bench,6,10,190,315"});
    EXPECT_EQ(bench.ask({"ENABLE"}), Answers{"ERR,ENABLE,STATE,not allowed in state U"});
    EXPECT_EQ(bench.ask({"SET,0" + kTargets}), Answers{"ERR,SET,STATE,not allowed in state U"});
    EXPECT_EQ(bench.ask({"HOME"}), Answers{"OK,HOME"});
    bench.wait(10ms);
    EXPECT_EQ(bench.ask({"ENABLE"}), Answers{"OK,ENABLE"});
    EXPECT_EQ(bench.ask({"SET,9" + kTargets}), Answers{});
    EXPECT_EQ(bench.ask({"SET,10,250,250,250,250,250,400"})[0].substr(0, 14), "ERR,SET,RANGE,");
    EXPECT_TRUE(bench.wait(10ms).back().ends_with(",E,9"));
    EXPECT_EQ(bench.ask({"DISABLE", "STOP", "CLEAR"}), (Answers{"OK,DISABLE", "OK,STOP", "OK,CLEAR"}));
    EXPECT_EQ(bench.state(), 'D');
    EXPECT_EQ(bench.ask({"PERIOD,50"}), Answers{"OK,PERIOD"});
    EXPECT_EQ(bench.ask({"HELLO,1"}), Answers{"IDENT,1,bench,6,50,190,315"});
}

TEST(LineController, SaysWhyARequestIsRefused) {
    const std::pair<const char*, const char*> rows[] = {
        {"SPEED,1", "ERR,SPEED,UNKNOWN,"},    {"LEN,1", "ERR,LEN,UNKNOWN,"},
        {"HELLO,2", "ERR,HELLO,RANGE,"},      {"HELLO", "ERR,HELLO,FORMAT,"},
        {"PERIOD,0", "ERR,PERIOD,RANGE,"},    {"PERIOD,1001", "ERR,PERIOD,RANGE,"},
        {"PERIOD,ten", "ERR,PERIOD,FORMAT,"}, {"STOP,now", "ERR,STOP,FORMAT,"},
        {"SET,1,2,3", "ERR,SET,FORMAT,"},     {"SET,1,nan,1,1,1,1,1", "ERR,SET,FORMAT,"}};
    Bench bench;
    for (const auto& [request, answer] : rows) {
        const Answers answers = bench.ask({request});
        ASSERT_EQ(answers.size(), 1U) << request;
        EXPECT_EQ(answers[0].substr(0, std::string(answer).size()), answer);
    }
    EXPECT_EQ(bench.ask({std::string(240, 'x')})[0].size(),
              std::string("ERR,,UNKNOWN,no such message").size() + 32);
    bench.controller.receive("garbage$SET,1*0000\n", bench.now);
    EXPECT_EQ(bench.answers(), Answers{}); // what came broken gets no answer
}

TEST(LineController, ReportsEveryPeriodCountingFramesAndTime) {
    Bench bench;
    const LegLengths home = testing_support::testPlatform().homeLengths();
    const Answers frames = bench.wait(35ms);
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_EQ(frames[0].substr(0, 12), "LEN,0,10000,");
    EXPECT_EQ(frames[2].substr(0, 12), "LEN,2,30000,");
    EXPECT_TRUE(frames[2].ends_with(",U,-1"));
    const line::LineMessage read = line::parsePayload(frames[2], line::Side::Host);
    EXPECT_LT((std::get<line::Len>(read).lengths - home).cwiseAbs().maxCoeff(), 0.51e-4);
    EXPECT_EQ(bench.controller.nextDue(), 40ms);
    EXPECT_LE(bench.wait(1h).size(), 2U); // a process that stood still does not make up for it
}

TEST(LineController, StopBeatsASetInTheSameBatch) {
    for (const bool stopFirst : {true, false}) {
        Bench bench;
        bench.enable();
        const std::string set = "SET,1" + kTargets;
        const Answers answers =
            stopFirst ? bench.ask({"STOP", "CLEAR", "ENABLE", set}) : bench.ask({set, "STOP"});
        EXPECT_EQ(std::count_if(answers.begin(), answers.end(),
                                [](const std::string& a) { return a.starts_with("ERR,SET,STATE"); }),
                  1);
        const LegLengths before = bench.controller.platform().lengths();
        EXPECT_TRUE(bench.wait(100ms).back().ends_with(",-1"));
        EXPECT_EQ(bench.controller.platform().lengths(), before);
    }
}

TEST(LineController, OnlyValidFramesKeepTheWatchdogQuiet) {
    for (const std::string& payload :
         {std::string("HELLO,1"), std::string("SET,0" + kTargets), std::string("HELLO,x")}) {
        Bench bench;
        bench.enable();
        for (int i = 0; i < 30; ++i) {
            bench.wait(20ms);
            bench.ask({payload});
            bench.controller.receive("$STOP*0000\n", bench.now);
        }
        EXPECT_EQ(bench.state(), payload == "HELLO,x" ? 'S' : 'E') << payload;
        bench.wait(251ms);
        EXPECT_EQ(bench.state(), 'S');
        EXPECT_EQ(bench.ask({"ENABLE"})[0].substr(0, 17), "ERR,ENABLE,STATE,");
        EXPECT_EQ(bench.ask({"CLEAR", "ENABLE"}), (Answers{"OK,CLEAR", "OK,ENABLE"}));
    }
}

TEST(LineController, TellsAFaultOnceAndHolds) {
    Bench bench;
    bench.enable();
    bench.ask({"SET,0" + kTargets});
    bench.wait(50ms);
    bench.controller.raiseFault("7", "drive 3 is hot");
    EXPECT_EQ(bench.answers(), Answers{"FAULT,7,drive 3 is hot"});
    const LegLengths held = bench.controller.platform().lengths();
    for (const std::string& frame : bench.wait(100ms))
        EXPECT_TRUE(frame.starts_with("LEN,") && frame.ends_with(",F,0")) << frame;
    EXPECT_EQ(bench.ask({"STOP", "CLEAR"}), (Answers{"OK,STOP", "OK,CLEAR"}));
    bench.wait(100ms);
    EXPECT_EQ(bench.state(), 'D');
    EXPECT_EQ(bench.controller.platform().lengths(), held);
}

} // namespace
} // namespace hexapose
