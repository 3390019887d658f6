// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/finite_step/drive_path.h"
#include "core/finite_step/mechanism.h"

#include <memory>
#include <string>

namespace hexapose {

/// The drive of a file: CSV with time_s and one column for each actuator, NAME_mm (the length of a leg, the
/// displacement of a slider from home) or NAME_deg (the turn of a crank from home); and, for all of them or
/// none, NAME_mm_per_s and NAME_mm_per_s2 (or deg). "-" is standard input. Throws InputError "file:line:
/// cause" for a missing column, a field that is not a finite number, times that do not rise, or fewer than
/// two rows.
std::unique_ptr<DrivePath> readDrive(const std::string& file, const Mechanism& mechanism);

/// The reference drive of a mechanism's file, over two seconds. Throws InputError when there is none.
std::unique_ptr<DrivePath> referenceDrive(const Mechanism& mechanism);

} // namespace hexapose
