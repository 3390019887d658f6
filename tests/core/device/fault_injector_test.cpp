// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/simulation/fault_injector.h"

#include "core/base/input_error.h"
#include "core/device/line/line_codec.h"

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace std::chrono_literals;

const std::string kFrame = line::frame("LEN,1,1000,339.5,336.5,336.6,329.2,345.1,334.5,E,-1");

/// What a host makes of 1000 frames, each spoilt.
LinkCounters read(const std::string& spec) {
    FaultInjector faults(parseFaultSpec(spec));
    line::FrameReader reader(line::Side::Host);
    std::vector<line::LineMessage> messages;
    for (int i = 0; i < 1000; ++i)
        reader.feed(faults.apply(kFrame, std::chrono::milliseconds(i)), messages);
    for (const line::LineMessage& message : messages)
        EXPECT_EQ(line::encode(message), kFrame);
    return reader.counters();
}

TEST(FaultSpec, ReadsEveryPiece) {
    const FaultSpec spec =
        parseFaultSpec("crc=0.01,drop=0.02,garbage=0.03,nan=0.04,torn=0.05,silence=10@5.5,noise=0.05,seed=7");
    EXPECT_EQ(spec.crc, 0.01);
    EXPECT_EQ(spec.drop, 0.02);
    EXPECT_EQ(spec.garbage, 0.03);
    EXPECT_EQ(spec.nan, 0.04);
    EXPECT_EQ(spec.torn, 0.05);
    EXPECT_EQ(spec.silence, 10s);
    EXPECT_EQ(spec.silenceAfter, 5500ms);
    EXPECT_DOUBLE_EQ(spec.noise, 5e-5);
    EXPECT_EQ(spec.seed, 7U);
}

TEST(FaultSpec, NamesTheBadPiece) {
    for (const std::string bad :
         {"crc", "crc=", "crc=2", "crc=-0.1", "crc=nan", "drop=x", "fire=1", "silence=10", "silence=a@1",
          "silence=1@-1", "noise=-1", "noise=inf", "seed=1.5", "seed=-1", "", "=1"}) {
        try {
            parseFaultSpec("torn=0.1," + bad);
            ADD_FAILURE() << "accepted: " << bad;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("\"" + bad + "\""), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(parseFaultSpec(""), InputError);
    EXPECT_THROW(parseFaultSpec("crc=0.1,crc=0.2"), InputError);
}

TEST(FaultInjector, EachFaultShowsUnderItsOwnCounter) {
    EXPECT_EQ(read("seed=1").accepted, 1000U);
    EXPECT_EQ(read("crc=1").droppedCrc, 1000U);
    EXPECT_EQ(read("nan=1").droppedNumber, 1000U);
    EXPECT_EQ(read("drop=1").accepted, 0U);
    EXPECT_EQ(read("torn=1").accepted, 0U);
    EXPECT_EQ(read("torn=1").droppedLength, 999U); // the last waits for the next
    EXPECT_GT(read("garbage=1").droppedGarbage, 500U);
    EXPECT_EQ(read("silence=0.5@0.25").accepted, 500U);
    EXPECT_NEAR(static_cast<double>(read("drop=0.2,seed=3").accepted), 800.0, 60.0);
}

TEST(FaultInjector, SpoilsTheSameWayForASeedAndLeavesAnswersTheirFields) {
    FaultInjector a(parseFaultSpec("crc=0.3,garbage=0.3,torn=0.3,drop=0.1,seed=9"));
    FaultInjector b(parseFaultSpec("crc=0.3,garbage=0.3,torn=0.3,drop=0.1,seed=9"));
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(a.apply(kFrame, 0s), b.apply(kFrame, 0s));
    EXPECT_EQ(FaultInjector(parseFaultSpec("nan=1")).apply(line::frame("OK,HOME"), 0s),
              line::frame("OK,HOME"));
}

} // namespace
} // namespace hexapose
