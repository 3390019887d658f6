// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace hexapose {

/// What a cycle of the loop is made of, in order.
enum class CyclePhase { Read, Estimate, Supervise, Generate, Write, Publish, End };
inline constexpr std::array kCyclePhases{CyclePhase::Read,     CyclePhase::Estimate, CyclePhase::Supervise,
                                         CyclePhase::Generate, CyclePhase::Write,    CyclePhase::Publish};

/// Told when each phase begins, and when the cycle ends; for measuring.
class CycleObserver {
public:
    virtual ~CycleObserver() = default;
    virtual void onPhase(CyclePhase begins) = 0;
};

} // namespace hexapose
