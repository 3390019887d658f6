// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/device/line/frame_sequence.h"

namespace hexapose::line {

namespace {

constexpr int kFramesOfRestart = 5; ///< so many in a row with a clock that went back are no stray ones
constexpr unsigned kHalfOfNumbers = 32768;

} // namespace

FrameSequence::Result FrameSequence::classify(std::uint16_t number, std::chrono::microseconds time) {
    const Mark mark{number, time};
    if (m_last && time < m_last->time)
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
