// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/error_picture.h"
#include "app/cli/reproduce/exhibit_text.h"
#include "app/cli/reproduce/exhibits.h"
#include "app/cli/reproduce/explanations.h"
#include "app/cli/reproduce/printed.h"
#include "core/base/number_text.h"

#include <cmath>

namespace hexapose::reproduce {

namespace {

using ErrorTable = std::vector<ErrorMeasurement>;

/// Errors of a run in the row's power of ten, one decimal more than printed.
std::vector<std::string> errorCells(const std::string& name, const published::ErrorRow& row,
                                    const MethodRun& run) {
    std::vector<std::string> cells{name};
    for (std::size_t k = 0; k < kCoordinates.size(); ++k)
        cells.push_back(formatFixed(run.meanError[kCoordinates[k].index] / std::pow(10.0, row.exponent),
                                    printed(row.digits[k], 0).decimals + 1));
    return cells;
}

std::vector<std::string> deviationCells(const ErrorMeasurement& row) {
    std::vector<std::string> cells{"  deviation"};
    for (std::size_t k = 0; k < kCoordinates.size(); ++k)
        cells.push_back(deviationText(row.measured.meanError[kCoordinates[k].index],
                                      printed(row.published.digits[k], row.published.exponent).value, 0));
    return cells;
}

void appendRow(Block& block, const ErrorMeasurement& row, bool withIterations) {
    const auto add = [&](std::vector<std::string> cells, const std::string& iterations) {
        if (withIterations)
            cells.push_back(iterations);
        block.rows.push_back({cells});
    };
    const published::ErrorRow& paper = row.published;
    block.rows.push_back({{title(paper) + ", in 1e" + std::to_string(paper.exponent)}, true});
    std::vector<std::string> digits{paper.misprint ? "  published (misprint)" : "  published"};
    digits.insert(digits.end(), paper.digits.begin(), paper.digits.end());
    add(digits, std::to_string(paper.iterations));
    add(errorCells("  measured", paper, row.measured), std::to_string(row.measured.iterations));
    add(deviationCells(row), deviationText(row.measured.iterations, paper.iterations, 1));
    if (row.exact)
        add(errorCells("  exact Jacobian", paper, *row.exact), std::to_string(row.exact->iterations));
}

Block errorBlock(const ErrorTable& table, bool withIterations) {
    Block block;
    block.header = {""};
    for (const Coordinate& coordinate : kCoordinates)
        block.header.push_back(std::string(coordinate.name) + " (" + coordinate.unit + ")");
    if (withIterations)
        block.header.push_back("iterations");
    for (const ErrorMeasurement& row : table)
        appendRow(block, row, withIterations);
    return block;
}

std::string errorCsv(const ErrorTable& table, bool withIterations) {
    std::string csv = csvLine({"algorithm", "set", "quantity", "unit", "published", "measured",
                               "deviation_percent", "exact_jacobian"});
    const auto add = [&](const ErrorMeasurement& row, const char* quantity, const char* unit,
                         double published, const auto& valueOf) {
        const double measured = valueOf(row.measured);
        csv += csvLine({title(row.published.algorithm), std::to_string(row.published.set), quantity, unit,
                        formatNumber(published), formatNumber(measured),
                        published == 0.0 ? "" : formatNumber(100.0 * (measured / published - 1.0)),
                        row.exact ? formatNumber(valueOf(*row.exact)) : ""});
    };
    for (const ErrorMeasurement& row : table) {
        for (std::size_t k = 0; k < kCoordinates.size(); ++k)
            add(row, kCoordinates[k].name, kCoordinates[k].unit,
                printed(row.published.digits[k], row.published.exponent).value,
                [&](const MethodRun& run) { return run.meanError[kCoordinates[k].index]; });
        if (withIterations)
            add(row, "iterations", "", row.published.iterations,
                [](const MethodRun& run) { return static_cast<double>(run.iterations); });
    }
    return csv;
}

void addTimes(Exhibit& exhibit, const ErrorTable& table) {
    constexpr int kDecimals = 4;
    Block block;
    block.header = {"seconds", "paper (MATLAB)", "measured", "exact Jacobian"};
    exhibit.timesCsv = csvLine({"algorithm", "set", "paper_matlab_s", "measured_s", "exact_jacobian_s"});
    for (const ErrorMeasurement& row : table) {
        const auto seconds = [](const MethodRun& run) {
            return run.seconds * published::kTestPoses / run.poses;
        };
        const double paper = row.published.matlabSeconds;
        const double measured = seconds(row.measured);
        block.rows.push_back({{title(row.published), formatFixed(paper, 3), formatFixed(measured, kDecimals),
                               row.exact ? formatFixed(seconds(*row.exact), kDecimals) : ""}});
        exhibit.timesCsv +=
            csvLine({title(row.published.algorithm), std::to_string(row.published.set), formatNumber(paper),
                     formatNumber(measured), row.exact ? formatNumber(seconds(*row.exact)) : ""});
    }
    exhibit.times = {block};
    exhibit.aboutTimes = kAboutTimes;
}

Exhibit makeErrorExhibit(const Experiment& experiment, const ErrorTable& table, bool withIterations) {
    Exhibit exhibit;
    exhibit.what =
        "Mean absolute errors over " + std::to_string(experiment.size().test) +
        " test poses; regressions fitted to " + std::to_string(experiment.size().training) +
        " others. Set 1: +-10 mm, +-10 deg; set 2: +-40 mm, +-40 deg. Newton stops at leg errors of "
        "1e-3 m or after 10 iterations, from home or from the regression. " +
        kColumns;
    exhibit.blocks = {errorBlock(table, withIterations)};
    exhibit.csv = errorCsv(table, withIterations);
    exhibit.picture = errorPicture(table, withIterations);
    addTimes(exhibit, table);
    return exhibit;
}

} // namespace

Exhibit makeTable2(Experiment& experiment, const Progress& progress) {
    const ErrorTable table = measureErrors(experiment, published::kTable2, progress);
    Exhibit exhibit = makeErrorExhibit(experiment, table, false);
    exhibit.name = "table2";
    exhibit.title = "Table 2: Newton's iteration and polynomial regression";
    exhibit.notes = {kFewDigits, kWhyLinear, kOneStepMore};
    exhibit.checkRule = "every error within 25 % or half a unit of its last printed digit";
    exhibit.checks = errorChecks(table);
    return exhibit;
}

Exhibit makeTable3(Experiment& experiment, const Progress& progress) {
    const ErrorTable table = measureErrors(experiment, published::kTable3, progress);
    Exhibit exhibit = makeErrorExhibit(experiment, table, true);
    exhibit.name = "table3";
    exhibit.title = "Table 3: Newton's iteration and MPR-NR";
    exhibit.what += " Iterations are totals.";
    exhibit.notes = {kTable3Misprint, kFewDigits, kWhyLinear, kOneStepMore};
    exhibit.checkRule = "iterations within 3 % for Newton and 10 % for MPR-NR, and 0 where 0 is printed";
    exhibit.checks = iterationChecks(table);
    return exhibit;
}

} // namespace hexapose::reproduce
