// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"

#include <optional>
#include <string>

namespace hexapose {

/// What is wrong with a platform that cannot be measured about home, because home is singular or nearly so,
/// and the likely cause where one fits: "its geometry is singular at home: base and platform joints form
/// similar figures". Nothing for a sound platform.
std::optional<std::string> faultOfHome(const PlatformGeometry& geometry);

} // namespace hexapose
