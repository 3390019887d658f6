// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/console/motion/named_poses.h"

#include <string>
#include <vector>

class QSettings;

namespace hexapose {

struct LoadedPoses {
    std::vector<NamedPose> poses;
    int dropped = 0; ///< entries that are not whole
};

/// The operator's named poses in the settings, apart for each machine: a pose of one may be out of another's
/// reach. An entry that is not whole is left out.
LoadedPoses loadNamedPoses(QSettings& settings, const std::string& platformFingerprint);
void saveNamedPoses(QSettings& settings, const std::string& platformFingerprint,
                    const std::vector<NamedPose>& poses);

} // namespace hexapose
