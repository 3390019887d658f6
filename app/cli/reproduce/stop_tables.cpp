// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/exhibits.h"
#include "app/cli/reproduce/explanations.h"
#include "app/cli/reproduce/printed.h"
#include "app/cli/reproduce/stop_pictures.h"
#include "core/base/number_text.h"

#include <cmath>

namespace hexapose::reproduce {

namespace {

using StopTable = std::vector<StopMeasurement>;
using StopMember = StopMethod StopMeasurement::*;

struct NamedMethod {
    const char* title;
    const char* word;
    StopMember member;
};
constexpr NamedMethod kStopMethods[] = {{"Newton", "newton", &StopMeasurement::newton},
                                        {"MPR-NR", "mpr_nr", &StopMeasurement::mprNewton}};

Block stopBlock(const StopTable& table, const NamedMethod& method) {
    Block block;
    block.groups = {{"D(X)", 4}, {"iterations", 4}};
    block.header = {std::string(method.title) + ", D(L)",
                    "published",
                    "measured",
                    "deviation",
                    "exact",
                    "published",
                    "measured",
                    "deviation",
                    "exact"};
    for (const StopMeasurement& row : table) {
        const StopMethod& m = row.*method.member;
        const double iterations = m.measured.meanIterations();
        block.rows.push_back(
            {{"1e" + formatFixed(std::log10(row.tolerance), 0), threeDigits(m.publishedDistance),
              threeDigits(m.measured.meanDistance),
              deviationText(m.measured.meanDistance, m.publishedDistance, 1),
              threeDigits(m.exact.meanDistance), formatFixed(m.publishedIterations, 2),
              formatFixed(iterations, 2), deviationText(iterations, m.publishedIterations, 1),
              formatFixed(m.exact.meanIterations(), 2)}});
    }
    return block;
}

/// The points of Figure 5.
Block pointBlock(const StopTable& table, const NamedMethod& method) {
    const auto logarithm = [](double value) { return formatFixed(std::log10(value), 2); };
    Block block;
    block.groups = {{"log10 D(X)", 3}, {"iterations", 3}};
    block.header = {std::string(method.title) + ", log10 D(L)",
                    "published",
                    "measured",
                    "exact",
                    "published",
                    "measured",
                    "exact"};
    for (const StopMeasurement& row : table) {
        const StopMethod& m = row.*method.member;
        block.rows.push_back(
            {{formatFixed(std::log10(row.tolerance), 0), logarithm(m.publishedDistance),
              logarithm(m.measured.meanDistance), logarithm(m.exact.meanDistance),
              formatFixed(m.publishedIterations, 2), formatFixed(m.measured.meanIterations(), 2),
              formatFixed(m.exact.meanIterations(), 2)}});
    }
    return block;
}

/// Slopes of Figure 5b.
Block slopeBlock(const StopTable& table) {
    Block block;
    block.header = {"iterations a decade of D(L)", "published", "measured", "deviation", "exact"};
    for (const NamedMethod& method : kStopMethods) {
        const auto slope = [&](const std::function<double(const StopMethod&)>& iterations) {
            return iterationsPerDecade(
                table, [&](const StopMeasurement& row) { return iterations(row.*method.member); });
        };
        const double published = slope([](const StopMethod& m) { return m.publishedIterations; });
        const double measured = slope([](const StopMethod& m) { return m.measured.meanIterations(); });
        const double exact = slope([](const StopMethod& m) { return m.exact.meanIterations(); });
        block.rows.push_back({{method.title, formatFixed(published, 2), formatFixed(measured, 2),
                               deviationText(measured, published, 1), formatFixed(exact, 2)}});
    }
    return block;
}

/// The table as it is, or the logarithms that Figure 5 shows.
std::string stopCsv(const StopTable& table, bool logarithms) {
    const std::string prefix = logarithms ? "log10_" : "";
    const auto scaled = [&](double value) { return formatNumber(logarithms ? std::log10(value) : value); };
    std::string csv = csvLine({"algorithm", prefix + "stop_dl_m", prefix + "dx_published",
                               prefix + "dx_measured", prefix + "dx_exact_jacobian", "iterations_published",
                               "iterations_measured", "iterations_exact_jacobian"});
    for (const NamedMethod& method : kStopMethods)
        for (const StopMeasurement& row : table) {
            const StopMethod& m = row.*method.member;
            csv += csvLine({method.word, scaled(row.tolerance), scaled(m.publishedDistance),
                            scaled(m.measured.meanDistance), scaled(m.exact.meanDistance),
                            formatNumber(m.publishedIterations), formatNumber(m.measured.meanIterations()),
                            formatNumber(m.exact.meanIterations())});
        }
    return csv;
}

/// Poses that an iteration gave up on; "" when there are none.
std::string unsolvedText(const StopTable& table) {
    int unsolved = 0;
    for (const StopMeasurement& row : table)
        for (const NamedMethod& method : kStopMethods)
            unsolved += (row.*method.member).measured.unsolved + (row.*method.member).exact.unsolved;
    return unsolved == 0
               ? ""
               : " Solutions that met no stop test, all rows together: " + std::to_string(unsolved) + ".";
}

Exhibit makeStopExhibit(const Experiment& experiment, const StopTable& table) {
    Exhibit exhibit;
    exhibit.what =
        "D(L): norm of the leg errors at which the iteration stops, m. D(X): mean Euclidean distance "
        "of the pose vectors, rad and m mixed. MPR-NR is the cubic one. Means over the " +
        std::to_string(experiment.size().test) + " test poses of set 2." + unsolvedText(table) + " " +
        kColumns;
    exhibit.blocks = {stopBlock(table, kStopMethods[0]), stopBlock(table, kStopMethods[1]),
                      slopeBlock(table)};
    exhibit.notes = {kWhyLinear};
    exhibit.checkRule =
        "1.39 iterations a decade as published; 4.3 and 2.7 iterations to 1e-10 m with the exact Jacobian; "
        "within 3 % for Newton and 10 % for MPR-NR";
    exhibit.checks = stopChecks(table);
    return exhibit;
}

} // namespace

Exhibit makeTable4(Experiment& experiment, const Progress& progress) {
    const StopTable table = measureStops(experiment, progress);
    Exhibit exhibit = makeStopExhibit(experiment, table);
    exhibit.name = "table4";
    exhibit.title = "Table 4: accuracy and iterations by the stop test";
    exhibit.blocks = {stopBlock(table, kStopMethods[0]), stopBlock(table, kStopMethods[1]),
                      slopeBlock(table)};
    exhibit.csv = stopCsv(table, false);
    exhibit.picture = stopDeviationPicture(table);
    return exhibit;
}

Exhibit makeFigure5(Experiment& experiment, const Progress& progress) {
    const StopTable table = measureStops(experiment, progress);
    Exhibit exhibit = makeStopExhibit(experiment, table);
    exhibit.name = "figure5";
    exhibit.title = "Figure 5: stop test, accuracy and iterations";
    exhibit.what = "The figure draws the numbers of Table 4. " + exhibit.what;
    exhibit.blocks = {pointBlock(table, kStopMethods[0]), pointBlock(table, kStopMethods[1]),
                      slopeBlock(table)};
    exhibit.csv = stopCsv(table, true);
    exhibit.picture = stopPicture(table);
    return exhibit;
}

} // namespace hexapose::reproduce
