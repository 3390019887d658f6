// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/finite_step/motion_tracking.h"
#include "ui/plot/picture.h"

namespace hexapose::reproduce {

/// Twelve panels as in the paper's Figure 16: posture, angular velocity and acceleration, below them their
/// errors; position, velocity and acceleration, below them theirs.
Picture trackingPicture(const StepSystem& system, const Track& track);

} // namespace hexapose::reproduce
