// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/pose.h"

#include <QString>

#include <vector>

namespace hexapose {

/// Writes poses as CSV with the columns that readPoseList() takes. The system's reason when it cannot.
QString saveWayPoints(const QString& file, const std::vector<Pose>& poses);

} // namespace hexapose
