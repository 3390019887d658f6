// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/viewer/export_job.h"

#include "app/common/table_problems.h"
#include "core/base/input_error.h"
#include "core/table/table_loader.h"
#include "ui/viewer/chart_export.h"

#include <QFile>

namespace hexapose {

namespace {

constexpr int kSomeMissing = 1;

} // namespace

int runExport(const ViewerOptions& options) {
    ChartPicture picture;
    picture.source = options.logs.front();
    picture.table = loadTable(picture.source);
    const Table& table = *picture.table;
    picture.layout =
        options.layout.empty() ? defaultLayout(table) : loadLayout(QFile::decodeName(options.layout.c_str()));
    if (!options.charts.empty())
        picture.layout = chosenCharts(picture.layout, table, options.charts);
    picture.time = {options.from.value_or(table.time().begin()), options.to.value_or(table.time().end())};
    if (!(picture.time.end > picture.time.begin))
        picture.time = {picture.time.begin - 0.5, picture.time.begin + 0.5};
    exportCharts(picture, options.exportFile);
    return printProblems(table) ? kSomeMissing : 0;
}

} // namespace hexapose
