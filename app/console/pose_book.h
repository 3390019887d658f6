// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/console/motion/named_poses.h"

#include <string>
#include <vector>

class QSettings;

namespace hexapose {

/// The operator's named poses in the settings, apart for each machine: a pose of one may be out of another's
/// reach. An entry that is not whole is passed over.
std::vector<NamedPose> loadNamedPoses(QSettings& settings, const std::string& platformFingerprint);
void saveNamedPoses(QSettings& settings, const std::string& platformFingerprint,
                    const std::vector<NamedPose>& poses);

} // namespace hexapose
