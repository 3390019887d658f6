// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#ifdef HEXAPOSE_EIGEN_ALIGN // comes with the installed library: what it was built with
static_assert(EIGEN_MAX_ALIGN_BYTES == HEXAPOSE_EIGEN_ALIGN,
              "hexapose was built for another vector unit (-march), by which Eigen lays out its matrices");
#endif

namespace hexapose {

inline constexpr int kLegCount = 6;

/// 6x1: one number a leg, leg 1 first.
using LegVector = Eigen::Matrix<double, kLegCount, 1>;

/// Distances between base joint and platform joint, metres, leg 1 first.
using LegLengths = LegVector;

} // namespace hexapose
