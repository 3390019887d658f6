// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace hexapose::line {

/// Classifies measurements by the controller's frame counter and clock: which are new, and how many never
/// came. A clock of 32 bits may begin again from 0.
class FrameSequence {
public:
    enum class Result {
        Accept,  ///< newer than everything before
        Discard, ///< repeated, or older
        Restart, ///< older, but so steadily that the controller must have started again; nothing before it
                 ///< counts
    };

    Result classify(std::uint16_t number, std::chrono::microseconds time);
    /// Frames the controller counted that never came.
    std::uint64_t missed() const { return m_missed; }

private:
    struct Mark {
        std::uint16_t number;
        std::chrono::microseconds time;
    };

    Result classifyOlder(const Mark& mark);

    std::optional<Mark> m_last;
    std::optional<Mark> m_older; ///< newest of a run of frames from before m_last
    int m_olderCount = 0;
    std::uint64_t m_missed = 0;
};

} // namespace hexapose::line
