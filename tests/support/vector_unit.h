// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/vector/lane_targets.h"

#include <hwy/highway.h>

#include <cstdint>

namespace hexapose::testing_support {

/// While it lives the whole process uses this kind of vector unit instead of the best one. No other thread
/// may be solving when it comes and goes.
class OnlyVectorUnit {
public:
    /// target: one of hwy::SupportedAndGeneratedTargets(), best first there.
    explicit OnlyVectorUnit(std::int64_t target) { choose(target); }
    ~OnlyVectorUnit() { choose(0); }
    OnlyVectorUnit(const OnlyVectorUnit&) = delete;
    OnlyVectorUnit& operator=(const OnlyVectorUnit&) = delete;

private:
    static void choose(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target); // 0: all again
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

} // namespace hexapose::testing_support
