// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/platform_geometry.h"

#include <string>

namespace hexapose {

/// Throws InputError, with the likely cause, for a platform with which nothing can move: its home is
/// singular.
void requireMovable(const PlatformGeometry& platform, const std::string& nameOrFile);

/// For a command that computes all the same: reports such a platform in one line on standard error.
void warnUnlessMovable(const PlatformGeometry& platform, const std::string& nameOrFile);

} // namespace hexapose
