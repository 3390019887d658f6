// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/pose_sequence.h"

#include <QString>

namespace hexapose {

/// Why a list of poses ended early.
QString sequenceEndText(const PoseSequence& sequence);

} // namespace hexapose
