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

} // namespace hexapose
