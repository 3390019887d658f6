// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/pose.h"

#include <filesystem>
#include <vector>

namespace hexapose {

/// A list of poses from CSV columns x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg. Throws InputError
/// "file:line: cause" for a missing column, a field that is not a finite number, or an empty list.
std::vector<Pose> readPoseList(const std::filesystem::path& file);

} // namespace hexapose
