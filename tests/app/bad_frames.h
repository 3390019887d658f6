// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/machine.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace hexapose::apptest {

/// What a LEN frame says.
struct LenFrame {
    std::uint16_t number = 0;
    std::int64_t microseconds = 0;
    Six lengths{};
    char state = 'U';
    int setNumber = -1;
    std::string payload(int decimals) const;
};

std::size_t badFrameCount();
/// Bytes of the index-th misbehaviour, to be sent right before the good frame `next`. None of them is a good
/// frame. The lengths in them lie far from the true ones, so that a pose from them would be seen.
std::string badFrame(std::size_t index, const LenFrame& last, const LenFrame& next, int decimals);

} // namespace hexapose::apptest
