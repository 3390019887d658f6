// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace hexapose {

/// State of the machine as the console sees it.
enum class RunState { Disconnected, Unreferenced, Disabled, Enabled, Moving, Settling, Stopped, Fault };

/// "disconnected", "unreferenced", ...: as in the log's state column.
std::string_view toWord(RunState state);
std::optional<RunState> runStateFromWord(std::string_view word);

/// The platform moves, or comes to rest at the end of a motion.
constexpr bool isInMotion(RunState state) {
    return state == RunState::Moving || state == RunState::Settling;
}
/// The drives are on, as far as the host knows.
constexpr bool drivesAreOn(RunState state) {
    return state == RunState::Enabled || isInMotion(state);
}
/// Stopped, or with a fault: Clear comes first.
constexpr bool isDown(RunState state) {
    return state == RunState::Stopped || state == RunState::Fault;
}

} // namespace hexapose
