// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace hexapose {

inline constexpr int kLegCount = 6;

/// One number a leg, leg 1 first.
using LegVector = Eigen::Matrix<double, kLegCount, 1>;

/// Distances between base joint and platform joint, metres, leg 1 first.
using LegLengths = LegVector;

} // namespace hexapose
