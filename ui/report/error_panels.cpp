// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "ui/plot/plot.h"
#include "ui/report/report_export.h"
#include "ui/report/report_words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hexapose {

namespace {

/// The size of one panel for which a unit is one pixel, and the space between two.
constexpr double kNaturalWidth = 780.0;
constexpr double kNaturalHeight = 283.0;
constexpr double kBetween = 14.0;
/// Side by side a panel may be narrower before its text shrinks.
constexpr double kNaturalWidthBeside = 580.0;
constexpr double kHeadroom = 1.12;
/// A bound that dwarfs the errors would flatten them into one line; then it only fills the background.
constexpr double kMostBandOverErrors = 6.0;

struct Panel {
    const char* label;
    int first; ///< coordinate of the pose vector
    std::array<const char*, 3> names;
};
constexpr Panel kAngles{QT_TRANSLATE_NOOP("hexapose::ReportWords", "Angle error (rad)"), 3, {"α", "β", "γ"}};
constexpr Panel kDisplacements{
    QT_TRANSLATE_NOOP("hexapose::ReportWords", "Displacement error (m)"), 0, {"x", "y", "z"}};

/// Three of the Okabe-Ito colours, which stay apart in colour-blind eyes and in grey.
const std::array<QColor, 3> kColours{QColor(0x00, 0x72, 0xB2), QColor(0xD5, 0x5E, 0x00),
                                     QColor(0x00, 0x9E, 0x73)};
constexpr std::array<Plot::Marker, 3> kMarkers{Plot::Marker::Circle, Plot::Marker::Square,
                                               Plot::Marker::Triangle};

AxisRange symmetric(double errors, double band) {
    const bool showBand = errors == 0.0 || band <= kMostBandOverErrors * errors;
    double reach = showBand ? std::max(errors, band) : errors;
    // Below any length or angle that means something there is only rounding to show.
    constexpr double kLeast = 1e-30;
    reach = reach < kLeast ? 1.0 : std::min(reach, 1e200) * kHeadroom;
    return {-reach, reach};
}

Plot makePlot(const ErrorReport& report, const Panel& panel) {
    Plot plot;
    plot.xLabel = ReportWords::tr("Sample");
    plot.yLabel = ReportWords::tr(panel.label);
    for (std::size_t k = 0; k < 3; ++k)
        plot.series.push_back({QString::fromUtf8(panel.names[k]), kColours[k], kMarkers[k], true, {}});
    Plot::Series failed{
        ReportWords::tr("no solution"), QColor(0x33, 0x33, 0x33), Plot::Marker::Cross, false, {}};
    Plot::Band band{ReportWords::tr("largest predicted for %1 mm resolution")
                        .arg(QString::fromStdString(formatNumber(mmFromMetres(report.resolution)))),
                    QColor(0xEC, 0xEA, 0xE4),
                    {}};
    double largestError = 0.0;
    double largestBound = 0.0;
    bool anyUsable = false;
    for (const ErrorRow& row : report.rows) {
        const bool usable = row.solution.isUsable();
        anyUsable = anyUsable || usable;
        for (int k = 0; k < 3; ++k) {
            const double error = usable ? row.error[panel.first + k] : std::nan("");
            plot.series[static_cast<std::size_t>(k)].points.emplace_back(row.number, error);
            if (std::isfinite(error))
                largestError = std::max(largestError, std::abs(error));
        }
        if (!usable)
            failed.points.emplace_back(row.number, 0.0);
        const double bound = row.predictedBound.segment<3>(panel.first).maxCoeff();
        band.steps.emplace_back(row.number, bound);
        if (std::isfinite(bound))
            largestBound = std::max(largestBound, bound);
    }
    plot.x = report.rows.empty()
                 ? AxisRange{0.5, 1.5}
                 : AxisRange{report.rows.front().number - 0.5, report.rows.back().number + 0.5};
    plot.y = symmetric(largestError, largestBound);
    if (report.rows.empty())
        plot.note = ReportWords::tr("No samples");
    else if (!anyUsable)
        plot.note = ReportWords::tr("No sample has a usable solution");
    plot.series.push_back(std::move(failed));
    plot.band = std::move(band);
    return plot;
}

} // namespace

void paintErrorPanels(QPainter& painter, const QRectF& area, const ErrorReport& report) {
    const double stacked =
        std::min(area.width() / kNaturalWidth, area.height() / (2.0 * kNaturalHeight + kBetween));
    const double beside =
        std::min(area.width() / (2.0 * kNaturalWidthBeside + kBetween), area.height() / kNaturalHeight);
    const double unit = std::max(stacked, beside);
    const QPointF step = beside > stacked ? QPointF((area.width() + kBetween * unit) / 2.0, 0.0)
                                          : QPointF(0.0, (area.height() + kBetween * unit) / 2.0);
    const QSizeF size = beside > stacked ? QSizeF(step.x() - kBetween * unit, area.height())
                                         : QSizeF(area.width(), step.y() - kBetween * unit);
    const PlotStyle style = paperStyle(unit);
    painter.fillRect(area, style.ground);
    paintPlot(painter, QRectF(area.topLeft(), size), makePlot(report, kAngles), style);
    paintPlot(painter, QRectF(area.topLeft() + step, size), makePlot(report, kDisplacements), style);
}

} // namespace hexapose
