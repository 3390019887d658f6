// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/limits.h"

#include <QString>

namespace hexapose {

/// "Reachable", or why not: which leg, which limit, by how much.
QString verdictText(const Verdict& verdict);

/// The same from a verdict's short words ("leg 3 above max_mm"), as an event carries them; the words
/// themselves when they are not known.
QString verdictTextFromWords(const QString& words);

/// Whether those words tell of a reason that lies on the way, while the target itself can be reached.
bool liesOnTheWay(const QString& words);

} // namespace hexapose
