// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"

namespace hexapose::bench {

/// What the model and the planner of a machine take: how near a pose is to a singular one, and whole plans,
/// of the machine and of two that planning once took long for.
void addPlanning(const PlatformGeometry& laboratory);

} // namespace hexapose::bench
