// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/stop_pictures.h"

#include "app/cli/reproduce/styles.h"

#include <array>
#include <cmath>

namespace hexapose::reproduce {

namespace {

constexpr double kStopHeadroom = 0.08;
using Value = std::function<double(const StopMethod&)>;

struct MethodStyle {
    QString title;
    StopMethod StopMeasurement::*member;
    QColor colour;
    QColor exactColour;
    Plot::Marker marker;
};

std::array<MethodStyle, 2> styles() {
    return {{{QStringLiteral("Newton"), &StopMeasurement::newton, kBlue, QColor(0x56, 0xB4, 0xE9),
              Plot::Marker::Circle},
             {QStringLiteral("MPR-NR"), &StopMeasurement::mprNewton, kVermilion, QColor(0xE6, 0x9F, 0x00),
              Plot::Marker::Square}}};
}

Plot emptyPlot(const QString& title, const QString& yLabel) {
    Plot plot;
    plot.title = title;
    plot.xLabel = QStringLiteral("log₁₀ D(L), stop test (m)");
    plot.yLabel = yLabel;
    plot.x = {-10.4, -2.6};
    return plot;
}

void addSeries(Plot& plot, Plot::Series series, const std::vector<StopMeasurement>& table,
               const MethodStyle& style, const Value& value) {
    for (const StopMeasurement& row : table)
        series.points.emplace_back(std::log10(row.tolerance), value(row.*style.member));
    plot.series.push_back(std::move(series));
}

Plot stopPlot(const std::vector<StopMeasurement>& table, Plot plot, const Value& published,
              const std::function<double(const MethodRun&)>& measured) {
    for (const MethodStyle& style : styles()) {
        addSeries(plot,
                  {style.title + QStringLiteral(" published"), style.colour, Plot::Marker::Ring, false, {}},
                  table, style, published);
        addSeries(plot, {style.title + QStringLiteral(" measured"), style.colour, style.marker, true, {}},
                  table, style, [&](const StopMethod& m) { return measured(m.measured); });
        addSeries(plot,
                  {style.title + QStringLiteral(" exact Jacobian"),
                   style.exactColour,
                   Plot::Marker::Triangle,
                   true,
                   {}},
                  table, style, [&](const StopMethod& m) { return measured(m.exact); });
    }
    plot.y = rangeOf(plot.series, kStopHeadroom);
    return plot;
}

/// The legend of all plots, from the first; names leave the plots.
void shareLegend(Picture& picture) {
    picture.legend = picture.plots.front().series;
    for (Plot& plot : picture.plots)
        for (Plot::Series& series : plot.series)
            series.name.clear();
}

} // namespace

Picture stopPicture(const std::vector<StopMeasurement>& table) {
    Picture picture;
    picture.title = QStringLiteral("Accuracy and iterations over the stop test");
    picture.panel = QSizeF(1080.0, 400.0);
    picture.plots = {
        stopPlot(
            table, emptyPlot(QStringLiteral("(a) accuracy"), QStringLiteral("log₁₀ D(X) (rad and m)")),
            [](const StopMethod& m) { return std::log10(m.publishedDistance); },
            [](const MethodRun& run) { return std::log10(run.meanDistance); }),
        stopPlot(
            table, emptyPlot(QStringLiteral("(b) iterations"), QStringLiteral("mean iterations")),
            [](const StopMethod& m) { return m.publishedIterations; },
            [](const MethodRun& run) { return run.meanIterations(); })};
    picture.plots[1].y.low = 0.0;
    shareLegend(picture);
    return picture;
}

Picture stopDeviationPicture(const std::vector<StopMeasurement>& table) {
    Picture picture;
    picture.title = QStringLiteral("Deviation of Table 4, measured from published");
    picture.panel = QSizeF(900.0, 215.0);
    Plot distance = emptyPlot(QStringLiteral("D(X)"), QStringLiteral("measured − published (%)"));
    Plot iterations = emptyPlot(QStringLiteral("iterations"), QStringLiteral("measured − published (%)"));
    for (const MethodStyle& style : styles()) {
        const Plot::Series series{style.title, style.colour, style.marker, true, {}};
        addSeries(distance, series, table, style, [](const StopMethod& m) {
            return 100.0 * (m.measured.meanDistance / m.publishedDistance - 1.0);
        });
        addSeries(iterations, series, table, style, [](const StopMethod& m) {
            return 100.0 * (m.measured.meanIterations() / m.publishedIterations - 1.0);
        });
    }
    for (Plot* plot : {&distance, &iterations}) {
        const AxisRange range = rangeOf(plot->series, kStopHeadroom);
        const double reach = std::max(std::abs(range.low), std::abs(range.high));
        plot->y = {-reach, reach};
    }
    picture.plots = {distance, iterations};
    shareLegend(picture);
    return picture;
}

} // namespace hexapose::reproduce
