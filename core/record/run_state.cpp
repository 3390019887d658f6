// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/record/run_state.h"

#include <array>
#include <utility>

namespace hexapose {

namespace {

constexpr std::array<std::pair<RunState, std::string_view>, 8> kStateWords{{
    {RunState::Disconnected, "disconnected"},
    {RunState::Unreferenced, "unreferenced"},
    {RunState::Disabled, "disabled"},
    {RunState::Enabled, "enabled"},
    {RunState::Moving, "moving"},
    {RunState::Settling, "settling"},
    {RunState::Stopped, "stopped"},
    {RunState::Fault, "fault"},
}};

} // namespace

std::string_view toWord(RunState state) {
    for (const auto& [value, word] : kStateWords)
        if (value == state)
            return word;
    return "unknown";
}

std::optional<RunState> runStateFromWord(std::string_view text) {
    for (const auto& [value, word] : kStateWords)
        if (word == text)
            return value;
    return std::nullopt;
}

} // namespace hexapose
