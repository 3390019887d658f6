// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/error_picture.h"

#include "app/cli/reproduce/printed.h"
#include "app/cli/reproduce/styles.h"

#include <algorithm>
#include <cmath>

namespace hexapose::reproduce {

namespace {

constexpr double kErrorHeadroom = 0.12;
constexpr double kLeastIterations = 100.0; ///< of a panel where all are 0

std::vector<Plot::Mark> coordinateMarks() {
    const std::array<QString, 6> names{QStringLiteral("α"), QStringLiteral("β"), QStringLiteral("γ"),
                                       QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    std::vector<Plot::Mark> marks;
    for (std::size_t k = 0; k < names.size(); ++k)
        marks.push_back({static_cast<double>(k), names[k]});
    return marks;
}

Plot errorPlot(const ErrorMeasurement& row) {
    Plot plot;
    plot.title = QString::fromStdString(title(row.published) + (row.published.misprint ? " (misprint)" : ""));
    plot.yLabel = QStringLiteral("log₁₀ mean error (rad, m)");
    plot.x = {-0.6, 5.6};
    plot.xMarks = coordinateMarks();
    plot.series = {seriesOf(Kind::Published, false), seriesOf(Kind::Exact, false),
                   seriesOf(Kind::Measured, false)};
    for (std::size_t k = 0; k < kCoordinates.size(); ++k) {
        const auto x = static_cast<double>(k);
        const int index = kCoordinates[k].index;
        plot.series[0].points.emplace_back(
            x, std::log10(printed(row.published.digits[k], row.published.exponent).value));
        plot.series[2].points.emplace_back(x, std::log10(row.measured.meanError[index]));
        if (row.exact)
            plot.series[1].points.emplace_back(x, std::log10(row.exact->meanError[index]));
    }
    plot.y = rangeOf(plot.series, kErrorHeadroom);
    return plot;
}

/// Totals of both sets of one algorithm.
Plot iterationPlot(const std::vector<ErrorMeasurement>& table, Algorithm algorithm) {
    Plot plot;
    plot.title = QString::fromLatin1(title(algorithm));
    plot.yLabel = QStringLiteral("iterations, total");
    plot.x = {0.4, 2.6};
    plot.xMarks = {{1.0, QStringLiteral("set 1")}, {2.0, QStringLiteral("set 2")}};
    plot.series = {seriesOf(Kind::Published, false), seriesOf(Kind::Exact, false),
                   seriesOf(Kind::Measured, false)};
    for (const ErrorMeasurement& row : table) {
        if (row.published.algorithm != algorithm)
            continue;
        const auto x = static_cast<double>(row.published.set);
        plot.series[0].points.emplace_back(x, row.published.iterations);
        plot.series[2].points.emplace_back(x, row.measured.iterations);
        if (row.exact)
            plot.series[1].points.emplace_back(x, row.exact->iterations);
    }
    const double high = std::max(rangeOf(plot.series, 0.0).high, kLeastIterations);
    plot.y = {-kErrorHeadroom * high, (1.0 + kErrorHeadroom) * high};
    return plot;
}

} // namespace

Picture errorPicture(const std::vector<ErrorMeasurement>& table, bool withIterations) {
    std::vector<Algorithm> algorithms;
    for (const ErrorMeasurement& row : table)
        if (std::find(algorithms.begin(), algorithms.end(), row.published.algorithm) == algorithms.end())
            algorithms.push_back(row.published.algorithm);
    Picture picture;
    picture.title = QStringLiteral("Mean absolute errors, published and measured");
    picture.columns = static_cast<int>(algorithms.size());
    picture.panel = QSizeF(310.0, 235.0);
    picture.legend = {seriesOf(Kind::Published, false), seriesOf(Kind::Measured, false),
                      seriesOf(Kind::Exact, false)};
    for (const int set : {1, 2})
        for (const ErrorMeasurement& row : table) // in the order of the algorithms
            if (row.published.set == set)
                picture.plots.push_back(errorPlot(row));
    if (withIterations)
        for (const Algorithm algorithm : algorithms)
            picture.plots.push_back(iterationPlot(table, algorithm));
    for (Plot& plot : picture.plots)
        for (Plot::Series& series : plot.series)
            series.name.clear(); // the picture has one legend for all
    return picture;
}

} // namespace hexapose::reproduce
