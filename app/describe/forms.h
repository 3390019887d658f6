// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/describe/describe.h"

namespace hexapose {

// The forms of describe().
std::string manOptions(const ProgramDescription& program);
std::string bashCompletion(const ProgramDescription& program);
std::string zshCompletion(const ProgramDescription& program);
std::string fishCompletion(const ProgramDescription& program);

// What more than one of them uses.

/// Of a program that has commands.
std::vector<OptionSpec> ownOptions();
/// As they are typed: "--steps", "--help", "-h".
std::vector<std::string> switchesOf(const std::vector<OptionSpec>& options);
std::string joined(const std::vector<std::string>& words, std::string_view between = " ");
std::string replaced(std::string text, std::string_view part, std::string_view by);
/// "_hexapose_cli", with which the names of a completion's functions begin.
std::string functionName(const ProgramDescription& program);

} // namespace hexapose
