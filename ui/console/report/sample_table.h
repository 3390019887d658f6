// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/error_report.h"

class QTableWidget;

namespace hexapose {

/// The table of samples: number, target, error, status; a foot with mean, RMS and largest error.
void prepareSampleTable(QTableWidget& table);
void nameSampleColumns(QTableWidget& table); ///< in the language of the screen
void fillSampleTable(QTableWidget& table, const ErrorReport& report);

} // namespace hexapose
