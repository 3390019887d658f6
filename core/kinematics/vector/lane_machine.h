// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/kinematics/leg_equations.h"
#include "core/kinematics/vector/newton_lanes.h"

namespace hexapose {

/// Part of the solvers' inside. A machine for the vector code, with the box about home in which it need not
/// ask for the side. homeDeterminant: of the scaled Jacobian; 0: singular there, and no box.
LaneMachine makeLaneMachine(const LegEquations& equations, double homeDeterminant);

} // namespace hexapose
