// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/frame_sequence.h"

namespace hexapose::line {

namespace {

constexpr int kFramesOfRestart = 5; ///< so many in a row with a clock that went back are no stray ones
constexpr unsigned kHalfOfNumbers = 32768;

/// Where a clock of 32 bits begins again from 0, every 71.6 minutes.
constexpr std::chrono::microseconds kClockRange{std::int64_t{1} << 32};
/// A step across that end is no longer than this; a controller that restarts looks the same to us only when
/// it does so within this time of the end, and then its state tells.
constexpr std::chrono::seconds kLongestWrap{10};

bool isWrap(std::chrono::microseconds before, std::chrono::microseconds after) {
    return before < kClockRange && after < before && after + kClockRange - before <= kLongestWrap;
}

} // namespace

FrameSequence::Result FrameSequence::classify(std::uint16_t number, std::chrono::microseconds time) {
    const Mark mark{number, time};
    if (m_last && !isWrap(m_last->time, time) && (time < m_last->time || isWrap(time, m_last->time)))
        return classifyOlder(mark);
    m_olderCount = 0;
    if (m_last) {
        const unsigned step = (static_cast<unsigned>(number) - m_last->number) & 0xFFFFU;
        if (step == 0 || time == m_last->time)
            return Result::Discard;
        if (step < kHalfOfNumbers) // a larger step is a counter set back, not a loss
            m_missed += step - 1;
    }
    m_last = mark;
    return Result::Accept;
}

FrameSequence::Result FrameSequence::classifyOlder(const Mark& mark) {
    const bool continues = m_olderCount > 0 && mark.time > m_older->time;
    m_olderCount = continues ? m_olderCount + 1 : 1;
    m_older = mark;
    if (m_olderCount < kFramesOfRestart)
        return Result::Discard;
    m_olderCount = 0;
    m_last = mark;
    return Result::Restart;
}

} // namespace hexapose::line
