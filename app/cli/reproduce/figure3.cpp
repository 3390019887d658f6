// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/exhibits.h"
#include "app/cli/reproduce/printed.h"
#include "app/cli/reproduce/sine_fit.h"
#include "app/cli/reproduce/styles.h"
#include "core/base/number_text.h"

#include <cmath>
#include <numbers>

namespace hexapose::reproduce {

namespace {

constexpr int kCurvePoints = 201;

double curvePoint(int index) {
    return 2.0 * std::numbers::pi * index / (kCurvePoints - 1);
}

Plot fitPlot(const SineFit& fit, const QString& title) {
    Plot plot;
    plot.title = title;
    plot.xLabel = QStringLiteral("x (rad)");
    plot.yLabel = QStringLiteral("y");
    plot.x = {0.0, 2.0 * std::numbers::pi};
    plot.y = {-1.25, 1.25};
    plot.series = {{QStringLiteral("sine, fitted points"), kBlue, Plot::Marker::Circle, false, {}},
                   {QStringLiteral("polynomial"), kVermilion, Plot::Marker::None, true, {}}};
    for (int i = 0; i < SineFit::kPoints; ++i)
        plot.series[0].points.emplace_back(SineFit::point(i), std::sin(SineFit::point(i)));
    for (int i = 0; i < kCurvePoints; ++i)
        plot.series[1].points.emplace_back(curvePoint(i), fit(curvePoint(i)));
    return plot;
}

Picture fitPicture(const SineFit& cubic, const SineFit& quintic) {
    Picture picture;
    picture.title = QStringLiteral("A cubic and a quintic fitted to a sine");
    picture.columns = 2;
    picture.panel = QSizeF(450.0, 320.0);
    picture.plots = {fitPlot(cubic, QStringLiteral("(a) cubic")),
                     fitPlot(quintic, QStringLiteral("(b) quintic"))};
    picture.legend = picture.plots.front().series;
    for (Plot& plot : picture.plots)
        for (Plot::Series& series : plot.series)
            series.name.clear();
    return picture;
}

std::string fitCsv(const SineFit& cubic, const SineFit& quintic) {
    std::string csv = "x_rad,sine,cubic,quintic\n";
    for (int i = 0; i < kCurvePoints; ++i) {
        const double x = curvePoint(i);
        csv += csvLine(
            {formatNumber(x), formatNumber(std::sin(x)), formatNumber(cubic(x)), formatNumber(quintic(x))});
    }
    return csv;
}

} // namespace

Exhibit makeFigure3(Experiment&, const Progress& progress) {
    progress(0.0);
    const SineFit cubic(3), quintic(5);
    Exhibit exhibit;
    exhibit.name = "figure3";
    exhibit.title = "Figure 3: a cubic and a quintic fitted to a sine";
    exhibit.what =
        "Least squares at " + std::to_string(SineFit::kPoints) +
        " equally spaced points of one period, 0 to 2 pi. The paper names neither interval nor "
        "points, and prints no numbers; these are our choice. No solver takes part, so that there is "
        "no column for one.";
    Block block;
    block.header = {"polynomial", "largest error", "rms error"};
    for (const SineFit* fit : {&cubic, &quintic})
        block.rows.push_back({{fit == &cubic ? "cubic" : "quintic", threeDigits(fit->largestError()),
                               threeDigits(fit->rmsError())}});
    exhibit.blocks = {block};
    exhibit.notes = {"The paper says that the error falls with the degree, and it does."};
    exhibit.csv = fitCsv(cubic, quintic);
    exhibit.picture = fitPicture(cubic, quintic);
    return exhibit;
}

} // namespace hexapose::reproduce
