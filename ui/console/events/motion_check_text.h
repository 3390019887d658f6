// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/motion/limits.h"

#include <QString>

namespace hexapose {

/// "Reachable", or why not: which leg, which limit, by how much.
QString motionCheckText(const MotionCheck& check);

/// The same from a check's short words ("leg 3 above max_mm"), as an event carries them; the words
/// themselves when they are not known.
QString motionCheckTextFromWords(const QString& words);

/// Whether those words tell of a reason that lies on the way, while the target itself can be reached.
bool liesAlongPath(const QString& words);

} // namespace hexapose
