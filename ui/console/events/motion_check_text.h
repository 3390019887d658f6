// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/motion/motion_check.h"

#include <QString>

namespace hexapose {

/// "Reachable", or why not: which leg, which limit, and by how much where that is known.
QString motionCheckText(const MotionCheck& check);

} // namespace hexapose
