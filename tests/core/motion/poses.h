// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/units.h"
#include "core/geometry/geometry_file.h"
#include "core/geometry/pose.h"

namespace hexapose::testing {

inline PlatformGeometry laboratory() {
    return loadPlatform(HEXAPOSE_SOURCE_DIR "/resources/platforms/laboratory.toml");
}

/// mm and deg.
inline Pose poseMm(double x, double y, double z, double alpha, double beta, double gamma) {
    return {{metresFromMm(x), metresFromMm(y), metresFromMm(z)},
            {radiansFromDeg(alpha), radiansFromDeg(beta), radiansFromDeg(gamma)}};
}

} // namespace hexapose::testing
