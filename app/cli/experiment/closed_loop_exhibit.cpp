// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/experiment/closed_loop_exhibit.h"

#include "app/cli/reproduce/printed.h"
#include "app/cli/reproduce/styles.h"
#include "core/base/number_text.h"
#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hexapose::experiment {

namespace {

using reproduce::Block;
using reproduce::Check;
using reproduce::Exhibit;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kAskedPart = 0.2;   ///< of joint mode's largest deviation is left in workspace mode
constexpr double kAskedSpeed = 0.05; ///< of the commanded speed

/// One quantity of a mode over all moves.
struct Quantity {
    const char* name;   ///< of the column in the table
    const char* column; ///< in the CSV
    double (*of)(const MoveOutcome& move);
    int decimals;
};

const Quantity kQuantities[] = {
    {"largest deviation (mm)", "deviation_mm",
     [](const MoveOutcome& m) { return mmFromMetres(m.largestDeviation); }, 3},
    {"largest deviation (deg)", "deviation_deg",
     [](const MoveOutcome& m) { return degFromRadians(m.largestAngleDeviation); }, 3},
    {"settling time (s)", "settling_s",
     [](const MoveOutcome& m) { return m.settleSeconds.value_or(kNothing); }, 2},
    {"final error (mm)", "final_mm", [](const MoveOutcome& m) { return mmFromMetres(m.finalError); }, 3},
    {"final error (deg)", "final_deg", [](const MoveOutcome& m) { return degFromRadians(m.finalAngle); }, 4},
    {"speed off by (%)", "speed_percent",
     [](const MoveOutcome& m) { return m.speedError ? 100.0 * *m.speedError : kNothing; }, 2},
};

std::vector<double> valuesOf(const std::vector<MoveOutcome>& moves, const Quantity& quantity) {
    std::vector<double> values;
    for (const MoveOutcome& move : moves)
        if (const double value = quantity.of(move); std::isfinite(value))
            values.push_back(value);
    return values;
}

double largest(const std::vector<double>& values) {
    return values.empty() ? kNothing : *std::max_element(values.begin(), values.end());
}
double mean(const std::vector<double>& values) {
    return values.empty()
               ? kNothing
               : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::string cell(double value, int decimals) {
    return std::isfinite(value) ? formatFixed(value, decimals) : "-";
}

Block summary(const char* name, const std::vector<MoveOutcome>& joint,
              const std::vector<MoveOutcome>& workspace) {
    Block block;
    block.groups = {{"joint mode", 2}, {"workspace mode", 2}, {"", 1}};
    block.header = {name, "mean", "largest", "mean", "largest", "joint / workspace"};
    for (const Quantity& quantity : kQuantities) {
        const std::vector<double> a = valuesOf(joint, quantity), b = valuesOf(workspace, quantity);
        const double ratio = largest(a) / largest(b);
        block.rows.push_back(
            {{quantity.name, cell(mean(a), quantity.decimals), cell(largest(a), quantity.decimals),
              cell(mean(b), quantity.decimals), cell(largest(b), quantity.decimals),
              std::isfinite(ratio) ? formatFixed(ratio, 1) : "-"}});
    }
    return block;
}

Block moveByMove(const std::vector<MoveOutcome>& joint, const std::vector<MoveOutcome>& workspace) {
    Block block;
    block.groups = {{"joint mode", 3}, {"workspace mode", 3}};
    block.header = {"move",      "dev. (mm)",   "settles (s)", "final (mm)",
                    "dev. (mm)", "settles (s)", "final (mm)"};
    for (std::size_t i = 0; i < joint.size(); ++i) {
        std::vector<std::string> cells{std::to_string(i + 1)};
        for (const int k : {0, 2, 3})
            cells.push_back(cell(kQuantities[k].of(joint[i]), kQuantities[k].decimals));
        for (const int k : {0, 2, 3})
            cells.push_back(cell(kQuantities[k].of(workspace[i]), kQuantities[k].decimals));
        block.rows.push_back({cells});
    }
    return block;
}

std::string csvOf(const BothModes& pushed, const BothModes& calm) {
    std::string csv = "move,mode,pushed,planned_s";
    for (const Quantity& quantity : kQuantities)
        csv += std::string(",") + quantity.column;
    csv += "\n";
    for (const BothModes* both : {&pushed, &calm})
        for (const auto* moves : {&both->joint, &both->workspace})
            for (std::size_t i = 0; i < moves->size(); ++i) {
                const MoveOutcome& move = (*moves)[i];
                std::vector<std::string> fields{
                    std::to_string(i + 1), moves == &both->joint ? "joint" : "workspace",
                    both == &pushed ? "yes" : "no", formatNumber(move.plannedSeconds)};
                for (const Quantity& quantity : kQuantities) {
                    const double value = quantity.of(move);
                    fields.push_back(std::isfinite(value) ? formatNumber(value) : "");
                }
                csv += reproduce::csvLine(fields);
            }
    return csv;
}

constexpr auto kDeviation = [](const Moment& m) { return mmFromMetres(m.deviation); };
constexpr auto kSpeed = [](const Moment& m) { return mmFromMetres(m.speed); };
constexpr auto kPlannedSpeed = [](const Moment& m) { return mmFromMetres(m.plannedSpeed); };

Plot::Series trace(const MoveOutcome& move, const char* name, const QColor& colour,
                   double (*value)(const Moment&)) {
    Plot::Series series{QString::fromLatin1(name), colour, Plot::Marker::None, true, {}};
    for (const Moment& moment : move.moments)
        series.points.emplace_back(moment.seconds, value(moment));
    return series;
}

Plot tracePlot(const QString& title, const QString& yLabel, std::vector<Plot::Series> series) {
    Plot plot;
    plot.title = title;
    plot.xLabel = QStringLiteral("time since the path began (s)");
    plot.yLabel = yLabel;
    double end = 0.0, top = 0.0;
    for (const Plot::Series& one : series)
        for (const QPointF& point : one.points) {
            end = std::max(end, point.x());
            top = std::max(top, point.y());
        }
    plot.x = {0.0, end};
    plot.y = {0.0, 1.1 * top};
    plot.series = std::move(series);
    for (int k = 0; k <= 4; ++k)
        plot.xMarks.push_back({end * k / 4.0, QString::number(end * k / 4.0, 'f', 1)});
    return plot;
}

/// A value of each move in both modes.
Plot movePlot(const QString& title, const QString& yLabel, const Quantity& quantity,
              const std::vector<MoveOutcome>& joint, const std::vector<MoveOutcome>& workspace) {
    Plot plot;
    plot.title = title;
    plot.xLabel = QStringLiteral("move");
    plot.yLabel = yLabel;
    plot.series = {{QStringLiteral("joint mode"), reproduce::kVermilion, Plot::Marker::Square, false, {}},
                   {QStringLiteral("workspace mode"), reproduce::kBlue, Plot::Marker::Circle, false, {}}};
    double top = 0.0;
    for (std::size_t i = 0; i < joint.size(); ++i)
        for (const std::size_t mode : {std::size_t{0}, std::size_t{1}}) {
            const double value = quantity.of(mode == 0 ? joint[i] : workspace[i]);
            plot.series[mode].points.emplace_back(static_cast<double>(i) + 1.0, value);
            top = std::isfinite(value) ? std::max(top, value) : top;
        }
    plot.x = {0.5, static_cast<double>(joint.size()) + 0.5};
    plot.y = {0.0, 1.1 * top};
    return plot;
}

std::size_t worstMove(const std::vector<MoveOutcome>& moves) {
    return static_cast<std::size_t>(std::max_element(moves.begin(), moves.end(),
                                                     [](const MoveOutcome& a, const MoveOutcome& b) {
                                                         return a.largestDeviation < b.largestDeviation;
                                                     }) -
                                    moves.begin());
}

Picture pictureOf(const std::vector<MoveOutcome>& joint, const std::vector<MoveOutcome>& workspace) {
    Picture picture;
    picture.title = QStringLiteral("Joint mode against workspace mode");
    picture.columns = 2;
    picture.panel = QSizeF(450.0, 320.0);
    const std::size_t i = worstMove(workspace);
    const QString move = QStringLiteral("move %1").arg(i + 1);
    picture.plots = {
        movePlot(QStringLiteral("Largest deviation of each move"), QStringLiteral("mm"), kQuantities[0],
                 joint, workspace),
        tracePlot(QStringLiteral("Deviation from the straight line, ") + move, QStringLiteral("mm"),
                  {trace(joint[i], "joint mode", reproduce::kVermilion, kDeviation),
                   trace(workspace[i], "workspace mode", reproduce::kBlue, kDeviation)}),
        tracePlot(QStringLiteral("Speed of P, ") + move, QStringLiteral("mm/s"),
                  {trace(joint[i], "joint mode", reproduce::kVermilion, kSpeed),
                   trace(workspace[i], "workspace mode", reproduce::kBlue, kSpeed),
                   trace(workspace[i], "commanded", reproduce::kBlack, kPlannedSpeed)}),
        movePlot(QStringLiteral("Settling time of each move"), QStringLiteral("s"), kQuantities[2], joint,
                 workspace),
    };
    for (const Plot::Series& series : picture.plots[2].series)
        picture.legend.push_back(series);
    for (Plot& plot : picture.plots)
        for (Plot::Series& series : plot.series)
            series.name.clear();
    return picture;
}

std::string mm(double metres) {
    return formatNumber(std::round(1e6 * mmFromMetres(metres)) / 1e6);
}

std::string describe(const TrialSettings& settings) {
    std::string constants;
    for (const double constant : settings.legs.timeConstants)
        constants += (constants.empty() ? "" : ", ") + formatNumber(std::round(1e6 * constant) / 1e3);
    std::string text =
        "The same " + std::to_string(settings.moves) + " moves on \"" + settings.platform.name +
        "\", leg by leg (joint mode) and with the loop closed on the pose (workspace mode), through the "
        "whole control loop and the line protocol. Legs: time constants " +
        constants + " ms, at most " + mm(settings.legs.speedLimit) + " mm/s, lengths in steps of " +
        mm(settings.legs.resolution) + " mm";
    if (settings.legs.noise > 0.0)
        text += " with noise of " + mm(settings.legs.noise) + " mm";
    if (settings.push != 0.0)
        text += ". During each move one leg, the next each time, is pushed by " + mm(settings.push) +
                " mm for " + formatNumber(settings.pushSeconds) + " s";
    return text + ". Deviations are those of the true platform from the straight line.";
}

} // namespace

Exhibit closedLoopExhibit(const TrialSettings& settings, const BothModes& pushed, const BothModes& calm) {
    const std::vector<MoveOutcome>& joint = pushed.joint;
    const std::vector<MoveOutcome>& workspace = pushed.workspace;
    Exhibit exhibit;
    exhibit.name = "closed-loop";
    exhibit.title = "Closed loop: joint mode against workspace mode";
    exhibit.what = describe(settings);
    exhibit.blocks = {summary("pushed", joint, workspace), summary("not pushed", calm.joint, calm.workspace),
                      moveByMove(joint, workspace)};
    exhibit.notes = {
        "Deviation: distance of P from the straight line, and of the rotation from the one that "
        "belongs to the place on "
        "it. Settling: from the end of the planned path until the platform was inside its "
        "window for the whole time. "
        "Speed: that of P over 100 ms against the commanded one, where that has been constant for 0.35 s and "
        "no push was on in the last 0.8 s; joint mode cannot be given a speed in the workspace."};
    const double part =
        largest(valuesOf(workspace, kQuantities[0])) / largest(valuesOf(joint, kQuantities[0]));
    exhibit.checkRule = "goals: deviation five times smaller, speed within 5 %, every move settles";
    exhibit.checks = {{"largest deviation, workspace over joint mode", 0.0, part, kAskedPart},
                      {"largest speed error in workspace mode", 0.0,
                       largest(valuesOf(calm.workspace, kQuantities[5])) / 100.0, kAskedSpeed},
                      {"moves that settle in workspace mode", static_cast<double>(workspace.size()),
                       static_cast<double>(valuesOf(workspace, kQuantities[2]).size()), 0.0}};
    if (valuesOf(calm.workspace, kQuantities[5]).empty()) // no move has a part of constant speed
        exhibit.checks.erase(exhibit.checks.begin() + 1);
    exhibit.csv = csvOf(pushed, calm);
    exhibit.picture = pictureOf(joint, workspace);
    return exhibit;
}

} // namespace hexapose::experiment
