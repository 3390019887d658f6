// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/common/arguments.h"
#include "app/common/table_problems.h"
#include "core/base/csv_table.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/table/column_summary.h"
#include "core/table/table_loader.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace hexapose {

namespace {

/// The columns of --columns, in the file's order; all of them without.
std::vector<std::size_t> chosenColumns(const Arguments& arguments, const Table& table) {
    std::vector<std::size_t> chosen;
    if (!arguments.has("columns")) {
        for (std::size_t i = 0; i < table.columns().size(); ++i)
            chosen.push_back(i);
        return chosen;
    }
    for (const QString& word :
         QString::fromStdString(arguments.text("columns", "")).split(QLatin1Char(','))) {
        const std::string name = word.trimmed().toStdString();
        const auto column = table.find(name);
        if (!column)
            throw InputError("--columns", "'" + name + "' is no column of " + table.sourceName());
        if (std::find(chosen.begin(), chosen.end(), *column) == chosen.end())
            chosen.push_back(*column);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

} // namespace

Usage summaryUsage() {
    return {"hexapose-cli summary",
            {QStringLiteral("LOG.csv")},
            {{"columns", "A,B", "These columns alone."},
             {"from", "S",
              "From this time on, in s: of the file's clock, or of its first row where times are dates."},
             {"to", "S", "Up to this time, included."}},
            "Count, extremes, mean and deviation of each column of a log, or of any CSV.",
            {},
            {}};
}

int summaryCommand(const Arguments& arguments) {
    constexpr double kForever = std::numeric_limits<double>::infinity();
    const double from = arguments.number("from", -kForever), to = arguments.number("to", kForever);
    if (from > to)
        throw InputError("--from", "is behind --to");
    const std::string file = arguments.operand(0);
    const std::shared_ptr<const Table> table = loadTable(file);
    const std::vector<RowRange> rows = arguments.has("from") || arguments.has("to")
                                           ? table->time().rowsBetween(from, to)
                                           : std::vector<RowRange>{{0, table->rowCount()}};
    std::string out = "column,unit,count,missing,min,max,mean,sigma,rms,first,last\n";
    for (const std::size_t index : chosenColumns(arguments, *table)) {
        const Column& column = table->columns()[index];
        out += csvField(column.info().name) + "," + csvField(column.info().unit);
        const ColumnSummary summary = summarize(column, rows);
        out += "," + std::to_string(summary.count) + "," + std::to_string(summary.missing);
        for (const std::string& text : {summary.min, summary.max, summary.mean, summary.sigma, summary.rms,
                                        summary.first, summary.last})
            out += "," + csvField(text);
        out += "\n";
    }
    std::fwrite(out.data(), 1, out.size(), stdout);
    return printProblems(*table) ? kExitSomeFailed : kExitDone;
}

} // namespace hexapose
