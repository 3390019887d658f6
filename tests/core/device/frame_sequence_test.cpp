// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/frame_sequence.h"

#include <gtest/gtest.h>

namespace hexapose::line {
namespace {

using namespace std::chrono_literals;
using Result = FrameSequence::Result;

constexpr std::chrono::microseconds kRange{std::int64_t{1} << 32}; // of a clock of 32 bits

TEST(FrameSequence, AClockOf32BitsBeginsAgainWithoutARestart) {
    for (const std::chrono::microseconds period : {1000us, 10000us, 1000000us}) {
        FrameSequence sequence;
        std::chrono::microseconds time = kRange - 5 * period / 2;
        for (std::uint16_t number = 65530; number != 10; ++number) {
            EXPECT_EQ(sequence.classify(number, time % kRange), Result::Accept) << time.count();
            time += period;
        }
        EXPECT_EQ(sequence.missed(), 0U);
    }
}

TEST(FrameSequence, CountsWhatIsLostAcrossTheEndOfTheClock) {
    FrameSequence sequence;
    EXPECT_EQ(sequence.classify(7, kRange - 1ms), Result::Accept);
    EXPECT_EQ(sequence.classify(11, 39ms), Result::Accept);
    EXPECT_EQ(sequence.missed(), 3U);
}

TEST(FrameSequence, AFrameFromBeforeTheEndOfTheClockIsOldAfterIt) {
    FrameSequence sequence;
    EXPECT_EQ(sequence.classify(7, kRange - 5ms), Result::Accept);
    EXPECT_EQ(sequence.classify(8, 5ms), Result::Accept);
    EXPECT_EQ(sequence.classify(7, kRange - 5ms), Result::Discard);
    EXPECT_EQ(sequence.classify(9, 15ms), Result::Accept);
    EXPECT_EQ(sequence.missed(), 0U);
}

TEST(FrameSequence, ARestartIsNoWrap) {
    // Far from the end of 32 bits, beyond it, and at it but with a clock that does not begin near 0.
    const std::pair<std::chrono::microseconds, std::chrono::microseconds> rows[] = {
        {kRange - 11s, 0us}, {kRange / 2, 0us}, {kRange + 1us, 5ms}, {kRange - 1ms, 11s}};
    for (const auto& [before, after] : rows) {
        FrameSequence sequence;
        EXPECT_EQ(sequence.classify(500, before), Result::Accept);
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(sequence.classify(static_cast<std::uint16_t>(i), after + i * 10ms), Result::Discard);
        EXPECT_EQ(sequence.classify(4, after + 40ms), Result::Restart) << before.count();
        EXPECT_EQ(sequence.classify(5, after + 50ms), Result::Accept);
    }
}

TEST(FrameSequence, CountsWhatNeverCameAcrossTheEndOfTheNumbers) {
    FrameSequence sequence;
    EXPECT_EQ(sequence.classify(65534, 10ms), Result::Accept);
    EXPECT_EQ(sequence.classify(65535, 20ms), Result::Accept);
    EXPECT_EQ(sequence.missed(), 0U);
    EXPECT_EQ(sequence.classify(2, 50ms), Result::Accept);
    EXPECT_EQ(sequence.missed(), 2U);
}

TEST(FrameSequence, TakesACounterThatIsSetBackForNoLoss) {
    FrameSequence sequence;
    EXPECT_EQ(sequence.classify(500, 10ms), Result::Accept);
    EXPECT_EQ(sequence.classify(0, 20ms), Result::Accept) << "the clock went on: it is a new measurement";
    EXPECT_EQ(sequence.missed(), 0U);
}

TEST(FrameSequence, DropsWhatIsRepeatedByNumberOrByTime) {
    FrameSequence sequence;
    EXPECT_EQ(sequence.classify(7, 10ms), Result::Accept);
    EXPECT_EQ(sequence.classify(7, 20ms), Result::Discard);
    EXPECT_EQ(sequence.classify(8, 10ms), Result::Discard);
    EXPECT_EQ(sequence.classify(8, 20ms), Result::Accept);
}

} // namespace
} // namespace hexapose::line
