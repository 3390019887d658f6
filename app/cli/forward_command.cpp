// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/number_rows.h"
#include "app/cli/solver_choice.h"
#include "core/geometry/input_error.h"
#include "core/geometry/units.h"
#include "core/record/unit_text.h"

#include <cstdio>
#include <string>

namespace hexapose {

namespace {

void appendRow(std::string& out, const ForwardResult& result) {
    if (result.hasPose()) {
        for (int k = 0; k < 3; ++k)
            out += mmText(result.pose.offset[k]) + ",";
        for (const double angle :
             {result.pose.angles.alpha, result.pose.angles.beta, result.pose.angles.gamma})
            out += degText(angle) + ",";
    } else {
        out += ",,,,,,";
    }
    out += std::string(toWord(result.status)) + "," + std::to_string(result.iterations) + ",";
    if (result.hasPose())
        out += mmText(result.residual);
    out += "\n";
}

} // namespace

int forwardCommand(const QStringList& words) {
    const Arguments arguments(
        "forward", {QStringLiteral("LENGTHS.csv")},
        {{"method", "M", "newton, newton-as-published, mpr2, mpr3, mpr2-nr or mpr3-nr (default)."},
         {"model", "FILE", "Regression model (default: the platform's own, trained on first use)."},
         {"start", "home|previous", "Where iteration begins (default: home)."},
         {"tolerance-mm", "T", "Largest residual of a solution, mm."},
         {"max-iterations", "N", "Most Newton iterations (default: 50)."}},
        words);
    const std::string start = arguments.text("start", "home");
    if (start != "home" && start != "previous")
        throw InputError("--start", "'" + start + "' is neither home nor previous");
    const PlatformGeometry platform = arguments.platform();
    const CsvTable table = readCsv(arguments.operand(0));
    const NumberRows rows(table, kLengthColumns);
    const ChosenSolver chosen = chooseSolver(arguments, platform);

    bool allOk = true;
    Pose from;
    std::string out = "x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg,status,iterations,residual_mm\n";
    for (const CsvTable::Row& row : everyRow(table)) {
        ForwardResult result; // invalid-input
        if (const auto lengths = rows.read(row))
            result = chosen.solver->solve(lengths->unaryExpr(&metresFromMm), from);
        if (start == "previous" && result.isUsable())
            from = result.pose;
        allOk = allOk && result.isUsable();
        appendRow(out, result);
    }
    std::fwrite(out.data(), 1, out.size(), stdout);
    return allOk ? kExitDone : kExitSomeFailed;
}

} // namespace hexapose
