// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/error_report.h"

#include <QDateTime>
#include <QIODevice>

namespace hexapose {

/// The report on A4: what was measured, statistics and figure on the first page, then the table of every
/// sample.
void writeErrorReportPdf(const ErrorReport& report, const QDateTime& date, QIODevice& device);

} // namespace hexapose
