// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/common/arguments.h"
#include "app/common/table_problems.h"
#include "core/analysis/compare_tables.h"
#include "core/base/csv_table.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/table/table_loader.h"

#include <cstdio>

namespace hexapose {

namespace {

double eventShift(const Table& a, const Table& b, const std::string& text) {
    const auto find = [&](const Table& table) {
        const auto time = timeOfEvent(table, text);
        if (!time)
            throw InputError("--align", "no event of " + table.sourceName() + " holds '" + text + "'");
        return *time;
    };
    const double first = find(a);
    return find(b) - first;
}

} // namespace

Usage compareUsage() {
    return {
        "hexapose-cli compare",
        {QStringLiteral("A.csv"), QStringLiteral("B.csv")},
        {{"shift", "S", "What happens at t in A happens at t + S in B (default: found from the columns)."},
         {"align", "EVENT", "The first event that holds this text happens in both at once."}},
        "How much the columns that two logs have in common differ.",
        {},
        {}};
}

int compareCommand(const Arguments& arguments) {
    if (arguments.has("shift") && arguments.has("align"))
        throw InputError("--align", "cannot be given beside --shift");
    const std::shared_ptr<const Table> a = loadTable(arguments.operand(0)),
                                       b = loadTable(arguments.operand(1));
    const std::vector<CommonColumn> columns = commonColumns(*a, *b);
    if (columns.empty())
        throw InputError(b->sourceName(), "has no column of numbers in common with " + a->sourceName());
    double shift = arguments.number("shift", 0.0);
    if (arguments.has("align"))
        shift = eventShift(*a, *b, arguments.requiredText("align"));
    else if (!arguments.has("shift"))
        shift = findShift(*a, *b, columns).value_or(0.0);
    std::string out = "column,unit,shift_s,count,rms,largest,largest_at_s\n";
    for (const CommonColumn column : columns) {
        const ColumnInfo& info = a->columns()[column.a].info();
        const ColumnDifference difference = compareColumn(*a, *b, column, shift);
        out += csvField(info.name) + "," + csvField(info.unit) + "," + formatNumber(shift) + "," +
               std::to_string(difference.count);
        if (difference.count > 0)
            out += "," + formatNumber(difference.rms) + "," + formatNumber(difference.largest) + "," +
                   formatNumber(difference.largestAt) + "\n";
        else
            out += ",,,\n";
    }
    std::fwrite(out.data(), 1, out.size(), stdout);
    const bool damagedA = printProblems(*a), damagedB = printProblems(*b);
    return damagedA || damagedB ? kExitSomeFailed : kExitDone;
}

} // namespace hexapose
