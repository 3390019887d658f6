// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The virtual platform as a program, spoken to by a host that shares no code with it.
#include "tests/app/foreign_host.h"
#include "tests/app/machine.h"
#include "tests/app/process.h"
#include "tests/app/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>

namespace hexapose::apptest {
namespace {

namespace fs = std::filesystem;
using Fields = ForeignHost::Fields;
using testing::StartsWith;

constexpr double kResolutionMm = 0.1;

std::string setPayload(int number, const Six& lengths) {
    constexpr double kUnit = 1e4; // four decimals; the protocol takes six at most
    std::string text = "SET," + std::to_string(number);
    for (const double length : lengths)
        text += "," + shortest(std::round(length * kUnit) / kUnit);
    return text;
}

Six lengthsOf(const Fields& fields) {
    Six lengths{};
    for (std::size_t i = 0; i < 6; ++i)
        lengths[i] = std::strtod(fields.at(3 + i).c_str(), nullptr);
    return lengths;
}

bool isNear(const Six& a, const Six& b, double tolerance) {
    for (std::size_t i = 0; i < 6; ++i)
        if (std::abs(a[i] - b[i]) > tolerance)
            return false;
    return true;
}

void bringUp(ForeignHost& host) {
    EXPECT_EQ(host.ask("HOME"), "OK,HOME");
    host.awaitState('D');
    EXPECT_EQ(host.ask("ENABLE"), "OK,ENABLE");
    host.awaitState('E');
}

TEST(Simulate, AnswersAsTheProtocolSays) {
    const Machine machine = laboratory();
    Process program(cliWords({"simulate", "--protocol", "line", "--period-ms", "20"}));
    ForeignHost host(program.readLine());
    const Fields ident = splitFields(host.ask("HELLO,1"));
    ASSERT_EQ(ident.size(), 7U);
    EXPECT_EQ(ident[0] + ident[1], "IDENT1");
    EXPECT_EQ(std::vector(ident.begin() + 3, ident.end()), (Fields{"6", "20", "250", "350"}));

    // Reports come by themselves, count up, and their clock never goes back.
    Fields before = host.awaitType("LEN");
    EXPECT_EQ(before.at(9), "U");
    EXPECT_EQ(before.at(10), "-1");
    for (int i = 0; i < 10; ++i) {
        const Fields now = host.awaitType("LEN");
        ASSERT_EQ(now.size(), 11U);
        EXPECT_EQ(std::atol(now[1].c_str()), (std::atol(before[1].c_str()) + 1) % 65536);
        EXPECT_GT(std::atoll(now[2].c_str()), std::atoll(before[2].c_str()));
        before = now;
    }

    EXPECT_THAT(host.ask("WARP,9"), StartsWith("ERR,WARP,UNKNOWN,"));
    EXPECT_THAT(host.ask("HELLO,2"), StartsWith("ERR,HELLO,"));
    EXPECT_THAT(host.ask("PERIOD,0"), StartsWith("ERR,PERIOD,RANGE,"));
    EXPECT_THAT(host.ask("PERIOD,1001"), StartsWith("ERR,PERIOD,RANGE,"));
    EXPECT_THAT(host.ask("PERIOD,fast"), StartsWith("ERR,PERIOD,FORMAT,"));
    EXPECT_THAT(host.ask("HOME,1"), StartsWith("ERR,HOME,FORMAT,"));
    EXPECT_THAT(host.ask("ENABLE"), StartsWith("ERR,ENABLE,STATE,")) << "unreferenced";
    EXPECT_THAT(host.ask(setPayload(0, machine.lengths({}))), StartsWith("ERR,SET,STATE,"));
    EXPECT_EQ(host.ask("PERIOD,10"), "OK,PERIOD");
    bringUp(host);

    EXPECT_THAT(host.ask("SET,1,300,300,300,300,300"), StartsWith("ERR,SET,FORMAT,"));
    EXPECT_THAT(host.ask("SET,1,300,300,300,300,300,nan"), StartsWith("ERR,SET,FORMAT,"));
    EXPECT_THAT(host.ask("SET,1,3e2,300,300,300,300,300"), StartsWith("ERR,SET,FORMAT,"));
    EXPECT_THAT(host.ask("SET,1,300,300,350.001,300,300,300"), StartsWith("ERR,SET,RANGE,"));
    EXPECT_THAT(host.ask("SET,1,249.9,300,300,300,300,300"), StartsWith("ERR,SET,RANGE,"));
    // Frames that are none get no answer and do nothing: the next answer belongs to the next question.
    host.write("$STOP*AF2F\n$STOP*af2e\n$STOP AF2E\nSTOP\n$ENABLE*$" + std::string(300, 'A') + "*0000\n");
    EXPECT_THAT(host.ask("WARP"), StartsWith("ERR,WARP,UNKNOWN,"));
    EXPECT_EQ(host.awaitType("LEN").at(9), "E");

    // It follows set-points, told over and over, at no more than its speed.
    const Six goal = machine.lengths({5, -3, 8, 1, 2, 3});
    int number = 65530; // and round again
    int lastSent = 0;
    const Fields there = host.await(
        [&](const Fields& f) { return f.front() == "LEN" && isNear(lengthsOf(f), goal, kResolutionMm); },
        [&] {
            lastSent = number++ % 65536;
            host.send(setPayload(lastSent, goal));
        });
    EXPECT_EQ(there.at(9), "E");
    EXPECT_LE(std::atoi(there.at(10).c_str()), 65535);
    EXPECT_EQ(host.ask("DISABLE"), "OK,DISABLE");
    host.awaitState('D');
    EXPECT_EQ(host.badItems(), 0) << host.badBytes().front();
    program.signal(SIGTERM);
    EXPECT_EQ(program.wait().status, 0);
}

TEST(Simulate, StopsOnSilenceAndWhenStopComesWithASet) {
    const Machine machine = laboratory();
    Process program(cliWords({"simulate", "--protocol", "line"}));
    ForeignHost host(program.readLine());
    host.ask("HELLO,1");
    bringUp(host);
    const Six home = machine.lengths({});
    const Six goal = machine.lengths({0, 0, 15, 0, 0, 0});

    // Silence: the last report before it, then S by the controller's own clock.
    host.send(setPayload(7, goal));
    const Fields last = host.await([](const Fields& f) { return f.front() == "LEN" && f.at(10) == "7"; });
    const Fields stopped = host.awaitState('S');
    const auto silence = std::atoll(stopped.at(2).c_str()) - std::atoll(last.at(2).c_str());
    constexpr long long kWatchdogUs = 250000, kPeriodUs = 10000, kSlackUs = 500000;
    EXPECT_GE(silence, kWatchdogUs - 2 * kPeriodUs);
    EXPECT_LE(silence, kWatchdogUs + kSlackUs);
    EXPECT_FALSE(isNear(lengthsOf(stopped), home, 1.0)) << "it had moved";
    EXPECT_THAT(host.ask("ENABLE"), StartsWith("ERR,ENABLE,STATE,")) << "CLEAR first";
    EXPECT_EQ(host.ask("CLEAR"), "OK,CLEAR");
    const Fields cleared = host.awaitState('D');
    EXPECT_EQ(cleared.at(10), "7");

    // STOP and SET in one batch, in either order.
    int number = 100;
    for (const bool stopFirst : {true, false}) {
        EXPECT_EQ(host.ask("ENABLE"), "OK,ENABLE");
        const Six from = lengthsOf(host.awaitState('E'));
        const std::string set = foreignFrame(setPayload(number++, home)), stop = foreignFrame("STOP");
        host.write(stopFirst ? stop + set : set + stop);
        host.awaitType("OK");
        const Fields after = host.awaitState('S');
        EXPECT_EQ(after.at(10), "7") << "the set-point beside a STOP is not taken";
        EXPECT_TRUE(isNear(lengthsOf(after), from, 2 * kResolutionMm));
        EXPECT_EQ(host.ask("CLEAR"), "OK,CLEAR");
        host.awaitState('D');
    }
}

TEST(Simulate, ServesAnotherPlatformBehindALink) {
    const Scratch scratch;
    const Machine machine = octahedral();
    const std::string link = scratch.path("port");
    fs::create_symlink("/nowhere", link); // of a program that was killed
    for (const int ending : {SIGTERM, SIGINT}) {
        Process program(cliWords({"simulate", "--link", link, "--protocol", "line", "--platform",
                                  scratch.file("octahedral.toml", machine.toml())}));
        const std::string port = program.readLine();
        EXPECT_EQ(fs::read_symlink(link), port);
        ForeignHost host(link);
        const Fields ident = splitFields(host.ask("HELLO,1"));
        EXPECT_EQ(std::vector(ident.begin() + 4, ident.end()), (Fields{"10", "350", "700"}));
        bringUp(host);
        EXPECT_TRUE(isNear(lengthsOf(host.awaitType("LEN")), machine.lengths({}), kResolutionMm));
        program.signal(ending);
        EXPECT_EQ(program.wait().status, 0);
        EXPECT_FALSE(fs::is_symlink(link));
    }
}

TEST(Simulate, FaultsAreWhatTheyAreSaidToBe) {
    Process program(cliWords({"simulate", "--protocol", "line", "--period-ms", "2", "--faults",
                              "crc=0.1,drop=0.1,garbage=0.1,nan=0.1,torn=0.1,seed=3"}));
    ForeignHost host(program.readLine());
    host.send("HELLO,1");
    int good = 0, nan = 0, missed = 0;
    long lastNumber = -1;
    host.await([&](const Fields& fields) {
        if (fields.front() != "LEN")
            return false;
        good += 1;
        nan += std::find(fields.begin(), fields.end(), "nan") != fields.end() ? 1 : 0;
        const long number = std::atol(fields.at(1).c_str());
        missed += lastNumber >= 0 && number != lastNumber + 1 ? 1 : 0;
        lastNumber = number;
        return good >= 400;
    });
    // Of 400 and more, a tenth each; a quarter of that would be chance in none of a million runs.
    EXPECT_GT(nan, 10);
    EXPECT_GT(missed, 40);
    EXPECT_GT(host.badItems(), 40);
    bool crc = false, garbage = false;
    for (const std::string& bytes : host.badBytes()) {
        crc = crc || (bytes.starts_with("$LEN,") && bytes.ends_with('\n'));
        garbage = garbage || !bytes.starts_with("$LEN");
    }
    EXPECT_TRUE(crc && garbage);
}

} // namespace
} // namespace hexapose::apptest
