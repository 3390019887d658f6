// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/cli/solver_choice.h"
#include "app/common/arguments.h"
#include "app/common/table_problems.h"
#include "core/analysis/solve_again.h"
#include "core/base/csv_table.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/record/log_metadata.h"
#include "core/table/table_loader.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace hexapose {

namespace {

/// That of --platform, else the recorded one beside the log, else the laboratory's.
PlatformGeometry platformOf(const std::string& file, const Arguments& arguments) {
    const std::filesystem::path beside = logMetadataFile(file);
    std::error_code ignored;
    if (file == "-" || beside == file || !std::filesystem::exists(beside, ignored))
        return arguments.platform();
    const RecordedMetadata recorded = readLogMetadata(beside);
    if (!arguments.has("platform"))
        return recorded.platform ? *recorded.platform : arguments.platform();
    return arguments.platform();
}

std::string wordOf(const Table& table, Row row, bool hasPose) {
    const auto column = table.find("status");
    if (column && table.columns()[*column].info().kind == CellKind::Word &&
        !table.columns()[*column].word(row).empty())
        return std::string(table.columns()[*column].word(row));
    return hasPose ? "pose" : "no pose";
}

std::string rowText(const Table& table, const Disagreement& one) {
    std::string text = std::to_string(table.lineOf(one.row)) + ",";
    if (!one.column)
        return text + "status," + csvField(wordOf(table, one.row, !one.isSolved)) + "," +
               std::string(toWord(one.status)) + "\n";
    return text + csvField(table.columns()[*one.column].info().name) + "," + formatNumber(one.recorded) +
           "," + formatNumber(one.solved) + "\n";
}

} // namespace

Usage verifyUsage() {
    return {"hexapose-cli verify",
            {QStringLiteral("LOG.csv")},
            {{"method", "M", "Forward method, as in 'forward'."},
             {"model", "FILE", "Regression model, as in 'forward'."},
             {"tolerance-mm", "T", "Largest difference of a position that counts as none (default: 1e-6)."},
             {"tolerance-deg", "D", "Largest difference of an angle (default: 1e-6)."}},
            "Solves the recorded lengths of a log again and lists the rows whose recorded pose differs.",
            {},
            "Platform name or file (default: that recorded beside the log, else laboratory)."};
}

int verifyCommand(const Arguments& arguments) {
    AgreementTolerance tolerance;
    tolerance.offset = metresFromMm(arguments.positive("tolerance-mm", 1e-6));
    tolerance.angle = radiansFromDeg(arguments.positive("tolerance-deg", 1e-6));
    const std::string file = arguments.operand(0);
    const PlatformGeometry platform = platformOf(file, arguments);
    const std::shared_ptr<const Table> table = loadTable(file);
    const auto lengths = findLengths(*table);
    if (!lengths)
        throw InputError(table->sourceName(), "has no six columns of lengths, l1 to l6, as in l1_mm");
    const auto pose = findMeasuredPose(*table);
    if (!pose)
        throw InputError(table->sourceName(), "has no recorded pose, x to gamma, as in x_mm and alpha_deg");
    const ChosenSolver chosen =
        chooseSolver(arguments, platform, SingularHome::Allowed, SolverTolerance::Default);
    const SolvedRows solved = solveAgain(*table, *lengths, *chosen.solver);
    const std::vector<Disagreement> differences = findDisagreements(*table, *pose, solved, tolerance);
    std::string out = "line,column,recorded,solved\n";
    for (const Disagreement& one : differences)
        out += rowText(*table, one);
    std::fwrite(out.data(), 1, out.size(), stdout);
    const bool damaged = printProblems(*table);
    return damaged || !differences.empty() ? kExitSomeFailed : kExitDone;
}

} // namespace hexapose
