// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/pose.h"

#include <variant>

namespace hexapose {

struct RunCommand {
    Pose target;
};
struct StopCommand {};
struct ReferenceCommand {};
struct EnableCommand {};
struct DisableCommand {};
struct ClearCommand {};

/// What an operator, or a program in their place, can ask for.
using OperatorCommand =
    std::variant<RunCommand, StopCommand, ReferenceCommand, EnableCommand, DisableCommand, ClearCommand>;

} // namespace hexapose
