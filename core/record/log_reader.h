// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/platform_geometry.h"
#include "core/record/snapshot.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hexapose {

/// A recorded session. Rows carry what the columns hold: time, measured and commanded lengths, goalPose,
/// measuredPose, status, iterations, residual, state, age, events; unknown columns are passed over, missing
/// optional ones stay empty. A row with lengths is a fresh measurement. Required: time_s and l1_mm..l6_mm.
struct SessionLog {
    std::vector<Snapshot> rows;
    std::optional<PlatformGeometry> platform; ///< from the TOML file beside it, when there is one
    std::string platformFingerprint;          ///< from there too; empty when not known
    std::string modelFingerprint;
    std::string solver; ///< method word; empty when not known
    std::string programVersion;
    std::vector<std::string> warnings; ///< with line numbers; a half-written last line is one. The first
                                       ///< hundred in full, then how many more
};

/// Throws InputError "file:line: cause" for what cannot be read at all, the TOML file beside it included:
/// numbers that were taken on another platform than the one assumed would look right. A row that cannot be
/// read is left out with a warning.
SessionLog readSessionLog(const std::filesystem::path& csvFile);

} // namespace hexapose
