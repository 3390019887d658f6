// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/leg_lengths.h"
#include "core/geometry/platform_geometry.h"

namespace hexapose::bench {

/// A platform and a pose as plain numbers: the yardsticks share nothing with what they are beside.
struct YardstickMachine {
    double base[kLegCount][3];
    double joint[kLegCount][3];
    double home[3];
};
YardstickMachine yardstickMachine(const PlatformGeometry& geometry);

/// What anybody would write with Eigen in an afternoon: Newton on x y z alpha beta gamma with the Euler-rate
/// matrix, PartialPivLU, fixed sizes; no guard, no branch, no status. Every figure is to be read against it.
/// pose: the start, then the result. Returns the iterations, -1 when there are too many.
int plainNewton(const YardstickMachine& machine, const double* lengths, double* pose, double tolerance);

/// The same source, compiled for this very processor: what one gets who gives up running anywhere else.
int plainNewtonNative(const YardstickMachine& machine, const double* lengths, double* pose, double tolerance);

} // namespace hexapose::bench
