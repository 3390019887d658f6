// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/record/motion_id.h"

#include <cstddef>
#include <utility>

namespace hexapose {

/// Who asks for motions on the screen.
enum class MotionAsker { Target = 1, Jog, JogStep, WayPoints, GuidedTest, Report };

inline constexpr int kMotionAskerShift = 48;

/// Numbers for the motions of one asker: no two askers of a window give the same.
class MotionIds {
public:
    explicit MotionIds(MotionAsker asker) : m_next((static_cast<MotionId>(asker) << kMotionAskerShift) + 1) {}
    /// The first of so many.
    MotionId take(std::size_t count = 1) { return std::exchange(m_next, m_next + count); }

private:
    MotionId m_next;
};

/// Whether a motion is one of an asker's.
inline bool isMotionOf(MotionAsker asker, MotionId id) {
    return id >> kMotionAskerShift == static_cast<MotionId>(asker);
}

} // namespace hexapose
