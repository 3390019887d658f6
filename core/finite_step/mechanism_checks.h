// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/finite_step/mechanism.h"

#include <string>

namespace hexapose {

// What is wrong with a part of a mechanism at home, in words; "" for nothing. Indices of points must be good.

/// A carried point: its three nodes on one line, or no nodes.
std::string carriageFault(const Mechanism& mechanism, const MechanismPoint& point);
/// An actuator whose ends coincide, or a crank without an arm.
std::string actuatorFault(const Mechanism& mechanism, const Actuator& actuator);
/// A distance of 0, or a circle whose centre is not the mean of its points.
std::string constraintFault(const Mechanism& mechanism, const Constraint& constraint);
/// Nodes that do not determine the orientation of the output.
std::string outputFault(const Mechanism& mechanism);

} // namespace hexapose
