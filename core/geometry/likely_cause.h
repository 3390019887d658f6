// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"

#include <functional>
#include <string>

namespace hexapose {

/// Mistakes that people make in a platform file, undone one at a time: the first that leaves a platform which
/// `fits` accepts, in words such as "platform_mm of each leg belongs to the leg before"; empty when none
/// does. A guess, for messages only.
std::string likelyMistake(const PlatformGeometry& geometry,
                          const std::function<bool(const PlatformGeometry&)>& fits);

/// Of a platform whose lengths at home are outside its strokes; empty for another.
std::string likelyMistakeOfStrokes(const PlatformGeometry& geometry);

/// Whether base and platform joints form the same figure, but for size, turn and mirroring. Such a platform
/// is singular whenever its plates are parallel.
bool areSimilarFigures(const PlatformGeometry& geometry);

} // namespace hexapose
