// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/visit_job.h"

#include <string>

namespace hexapose {

/// Why a job ended early, and what its end left to report, in one line for standard error; empty when
/// nothing did.
std::string failureWords(const VisitJob& job);

} // namespace hexapose
