// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewer/chart_layout.h"
#include "ui/viewer/table_marks.h"

#include <filesystem>
#include <memory>

namespace hexapose {

/// What an export shows.
struct ChartPicture {
    std::shared_ptr<const Table> table;
    ChartLayout layout;
    TimeSpan time;
    std::filesystem::path source; ///< the file that the rows of a CSV are copied from
};

/// The kinds of files that there are: "png", "svg", "pdf", "csv".
bool isExportKind(const std::filesystem::path& file);

/// The charts as a picture, or the rows as CSV, as the file's ending says. Nobody ever sees half of it.
/// Throws InputError.
void exportCharts(const ChartPicture& picture, const std::filesystem::path& file);

} // namespace hexapose
