// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/viewer/viewer_options.h"

namespace hexapose {

/// --export: the whole log is read, and what is asked for is written. The exit status: 0, or 1 when the log
/// has rows or cells that could not be read. Throws InputError.
int runExport(const ViewerOptions& options);

} // namespace hexapose
