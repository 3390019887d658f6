// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <utility>

namespace hexapose {

/// The state that a controller reports of itself.
enum class ControllerState { Unknown, Unreferenced, Disabled, Enabled, Stopped, Fault };

/// The letters by which the line protocol, and the log after it, name these states.
inline constexpr std::array<std::pair<ControllerState, char>, 6> kControllerStateLetters{{
    {ControllerState::Unknown, '?'},
    {ControllerState::Unreferenced, 'U'},
    {ControllerState::Disabled, 'D'},
    {ControllerState::Enabled, 'E'},
    {ControllerState::Stopped, 'S'},
    {ControllerState::Fault, 'F'},
}};

constexpr char toLetter(ControllerState state) {
    return kControllerStateLetters[static_cast<std::size_t>(state)].second;
}

constexpr std::optional<ControllerState> controllerStateFromLetter(char letter) {
    for (const auto& [state, known] : kControllerStateLetters)
        if (known == letter)
            return state;
    return std::nullopt;
}

} // namespace hexapose
