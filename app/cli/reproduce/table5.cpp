// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/exhibits.h"
#include "app/cli/reproduce/explanations.h"
#include "app/cli/reproduce/printed.h"
#include "app/cli/reproduce/published_table5.h"
#include "app/cli/reproduce/styles.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/kinematics/catalog/forward_methods.h"

#include <cmath>
#include <limits>

namespace hexapose::reproduce {

namespace {

/// The first is the iteration as published; the others have the exact Jacobian.
constexpr const char* kMethods[] = {"newton-as-published", "newton", "mpr2-nr", "mpr3-nr"};

struct Solved {
    std::string method;
    ForwardResult result;
};

std::vector<Solved> solvePublished(Experiment& experiment, const Progress& progress) {
    LegLengths lengths;
    for (int i = 0; i < kLegCount; ++i)
        lengths[i] = metresFromMm(published::kTable5LengthsMm[static_cast<std::size_t>(i)]);
    std::vector<Solved> solved;
    for (const char* word : kMethods) {
        progress(static_cast<double>(solved.size()) / std::size(kMethods));
        const ForwardMethod& method = *findForwardMethod(word);
        const PolynomialModel* model =
            method.modelDegree == 0 ? nullptr : &experiment.model(2, method.modelDegree);
        const auto solver = makeForwardSolver(method, experiment.platform(), model, NewtonOptions{});
        solved.push_back({word, solver->solve(lengths, Pose{})});
    }
    return solved;
}

std::string fourDigits(double value) {
    return inDigits(value, 4);
}

Block poseBlock(const std::vector<Solved>& solved) {
    Block block;
    block.groups = {{"", 2}, {"as published", 1}, {"exact Jacobian", 3}};
    block.header = {"", "reference", "published"};
    for (const Solved& s : solved)
        block.header.push_back(s.method);
    for (const published::Table5Row& row : published::kTable5) {
        std::vector<std::string> cells{std::string(row.coordinate) + " (" + row.unit + ")",
                                       fourDigits(row.reference), fourDigits(row.solved)};
        for (const Solved& s : solved)
            cells.push_back(fourDigits(s.result.pose.toVector()[row.index]));
        block.rows.push_back({cells});
    }
    block.rows.push_back({{"iterations", "", ""}});
    for (const Solved& s : solved)
        block.rows.back().cells.push_back(std::to_string(s.result.iterations));
    return block;
}

std::string poseCsv(const std::vector<Solved>& solved) {
    std::vector<std::string> header{"coordinate", "unit", "reference", "published"};
    for (const Solved& s : solved)
        header.push_back(s.method);
    std::string csv = csvLine(header);
    for (const published::Table5Row& row : published::kTable5) {
        std::vector<std::string> fields{row.coordinate, row.unit, formatNumber(row.reference),
                                        formatNumber(row.solved)};
        for (const Solved& s : solved)
            fields.push_back(formatNumber(s.result.pose.toVector()[row.index]));
        csv += csvLine(fields);
    }
    return csv;
}

/// Within one unit of the last printed digit, the misprint corrected; NaN for a method that found no pose.
std::vector<Check> poseChecks(const std::vector<Solved>& solved) {
    std::vector<Check> checks;
    for (const Solved& s : solved)
        for (const published::Table5Row& row : published::kTable5) {
            const bool converged = s.result.status == SolveStatus::Converged;
            checks.push_back(
                {s.method + ", " + row.coordinate + " (" + row.unit + ")", row.corrected,
                 converged ? s.result.pose.toVector()[row.index] : std::numeric_limits<double>::quiet_NaN(),
                 row.lastDigit});
        }
    return checks;
}

/// What the operator set, in m or rad, without the rounding of the printed reference.
double target(const published::Table5Row& row) {
    return std::string_view(row.coordinate) == "gamma" ? radiansFromDeg(5.0) : row.reference;
}

/// Differences from the target, of three rows of the table.
Plot differencePlot(const std::vector<Solved>& solved, std::size_t first, const QString& label,
                    const std::array<QString, 3>& names) {
    Plot plot;
    plot.yLabel = label;
    plot.x = {-0.5, 2.5};
    plot.series = {seriesOf(Kind::Published, false),
                   {QStringLiteral("published, misprint corrected"), kGreen, Plot::Marker::Ring, false, {}},
                   seriesOf(Kind::Exact, false),
                   seriesOf(Kind::Measured, false)};
    for (std::size_t k = 0; k < names.size(); ++k) {
        const published::Table5Row& row = published::kTable5[first + k];
        const auto x = static_cast<double>(k);
        plot.xMarks.push_back({x, names[k]});
        plot.series[0].points.emplace_back(x, row.solved - target(row));
        if (row.corrected != row.solved)
            plot.series[1].points.emplace_back(x, row.corrected - target(row));
        for (std::size_t s = 0; s < 2; ++s) // as published on top of exact
            plot.series[3 - s].points.emplace_back(x,
                                                   solved[s].result.pose.toVector()[row.index] - target(row));
    }
    constexpr double kHeadroom = 0.12;
    plot.y = rangeOf(plot.series, kHeadroom);
    return plot;
}

Picture differencePicture(const std::vector<Solved>& solved) {
    Picture picture;
    picture.title = QStringLiteral("The pose of the physical test, published and measured");
    picture.columns = 2;
    picture.panel = QSizeF(450.0, 320.0);
    picture.plots = {differencePlot(solved, 0, QStringLiteral("angle − reference (rad)"),
                                    {QStringLiteral("α"), QStringLiteral("β"), QStringLiteral("γ")}),
                     differencePlot(solved, 3, QStringLiteral("displacement − reference (m)"),
                                    {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")})};
    picture.legend = picture.plots.front().series;
    for (Plot& plot : picture.plots)
        for (Plot::Series& series : plot.series)
            series.name.clear();
    return picture;
}

} // namespace

Exhibit makeTable5(Experiment& experiment, const Progress& progress) {
    const std::vector<Solved> solved = solvePublished(experiment, progress);
    Exhibit exhibit;
    exhibit.name = "table5";
    exhibit.title = "Table 5: the physical test";
    exhibit.what =
        "The pose of the lengths 339.5 336.5 336.6 329.2 345.1 334.5 mm, which the drives reported "
        "at the target 0 0 5 deg, 12 -4 40 mm.";
    exhibit.blocks = {poseBlock(solved)};
    exhibit.notes = {kTable5Misprint};
    exhibit.checkRule = "every method within one unit of the last printed digit, the misprint corrected";
    exhibit.checks = poseChecks(solved);
    exhibit.csv = poseCsv(solved);
    exhibit.picture = differencePicture(solved);
    return exhibit;
}

} // namespace hexapose::reproduce
