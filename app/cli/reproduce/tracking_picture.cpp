// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/tracking_picture.h"

#include "app/cli/reproduce/styles.h"
#include "app/cli/reproduce/tracking_table.h"
#include "ui/plot/nice_ticks.h"

#include <algorithm>

namespace hexapose::reproduce {

namespace {

constexpr double kHeadroom = 0.08;
constexpr std::size_t kMostPoints = 400; ///< of a curve
constexpr int kMostMarks = 5;

std::vector<Plot::Series> axisSeries(bool named) {
    const auto name = [named](const char* axis) { return named ? QString::fromLatin1(axis) : QString(); };
    return {{name("x"), kBlue, Plot::Marker::None, true, {}},
            {name("y"), kVermilion, Plot::Marker::None, true, {}},
            {name("z"), kGreen, Plot::Marker::None, true, {}}};
}

Plot timePlot(const Track& track, const QString& title, const QString& unit) {
    Plot plot;
    plot.title = title;
    plot.yLabel = unit;
    plot.xLabel = QStringLiteral("t (s)");
    plot.x = {track.rows.front().time, std::max(track.rows.back().time, track.rows.front().time + 1e-9)};
    const Ticks ticks = niceTicks(plot.x.low, plot.x.high, kMostMarks);
    for (std::size_t i = 0; i < ticks.values.size(); ++i)
        plot.xMarks.push_back({ticks.values[i], ticks.labels[i] + timesPowerOfTen(ticks.exponent)});
    plot.series = axisSeries(false);
    return plot;
}

} // namespace

Picture trackingPicture(const StepSystem& system, const Track& track) {
    Picture picture;
    picture.title = QStringLiteral("Motion of the platform, and its errors");
    picture.columns = 3;
    picture.panel = QSizeF(380.0, 240.0);
    picture.legend = axisSeries(true);
    const std::size_t stride = std::max<std::size_t>(1, track.rows.size() / kMostPoints);
    char letter = 'a';
    for (const std::size_t half : {0U, 3U})
        for (const bool errors : {false, true})
            for (std::size_t i = half; i < half + 3; ++i) {
                const TrackQuantity& quantity = kTrackQuantities[i];
                Plot plot = timePlot(
                    track,
                    QStringLiteral("(%1) %2%3")
                        .arg(QLatin1Char(letter++))
                        .arg(QLatin1String(quantity.title), errors ? QStringLiteral(" error") : QString()),
                    QString::fromUtf8(quantity.unit));
                for (std::size_t k = 0; k < track.rows.size(); k += stride) {
                    const TrackRow& row = track.rows[k];
                    const Eigen::Vector3d value =
                        errors ? trackErrors(row)[i] : trackValues(system, row.computed)[i];
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        plot.series[axis].points.emplace_back(row.time,
                                                              value[static_cast<Eigen::Index>(axis)]);
                }
                plot.y = rangeOf(plot.series, kHeadroom);
                picture.plots.push_back(plot);
            }
    return picture;
}

} // namespace hexapose::reproduce
