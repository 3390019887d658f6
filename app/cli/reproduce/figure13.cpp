// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/exhibits.h"
#include "app/cli/reproduce/experiment.h"
#include "app/cli/reproduce/finite_step_study.h"
#include "app/cli/reproduce/printed.h"
#include "app/cli/reproduce/styles.h"
#include "core/base/number_text.h"
#include "core/base/units.h"

#include <cmath>

namespace hexapose::reproduce {

namespace figure13 {
namespace {

constexpr std::array<int, 9> kSteps{10, 30, 100, 300, 1000, 3000, 4500, 10000, 30000};
/// Between these the order is measured: fine enough for the leading term, and above rounding.
struct OrderRange {
    StepForm form;
    int coarse, fine;
    double order;
};
constexpr std::array<OrderRange, 3> kOrders{{{StepForm::Open, 1000, 10000, 1.0},
                                             {StepForm::Closed, 300, 3000, 2.0},
                                             {StepForm::Corrected, 30, 100, 4.0}}};
constexpr double kOrderAllowed = 0.1;
/// What the paper says in words (section 5.2): 0.2 um at 4500 steps, of a target that it does not print.
constexpr int kPublishedSteps = 4500;
constexpr double kPublishedMicrometres = 0.2;
constexpr double kPublishedPart = 0.25;
constexpr double kPublishedSeconds = 0.5;
/// Errors below this are rounding, and are left out of the chart.
constexpr double kFloorMm = 1e-10;

struct Study {
    std::vector<StepMeasurement> near, wide;
};

Study measure(const PlatformGeometry& platform, const Progress& progress) {
    Study study;
    double done = 0.0;
    for (const StepForm form : kStepForms)
        for (const int steps : kSteps) {
            progress(done / static_cast<double>(kStepForms.size() * kSteps.size()));
            study.near.push_back(measureSteps(platform, nearTarget(), form, steps));
            study.wide.push_back(measureSteps(platform, wideTarget(), form, steps));
            done += 1.0;
        }
    return study;
}

const StepMeasurement& find(const std::vector<StepMeasurement>& all, StepForm form, int steps) {
    for (const StepMeasurement& one : all)
        if (one.form == form && one.steps == steps)
            return one;
    return all.front();
}

Block errorBlock(const Study& study) {
    Block block;
    block.groups = {{"near target", 2}, {"wide target", 2}, {"wide: angles of the axes (deg)", 3}};
    block.header = {"steps", "position (mm)", "turn (deg)", "position (mm)", "turn (deg)", "x", "y", "z"};
    for (const StepForm form : kStepForms) {
        block.rows.push_back({{std::string(toWord(form))}, true});
        for (const int steps : kSteps) {
            const StepMeasurement& near = find(study.near, form, steps);
            const StepMeasurement& wide = find(study.wide, form, steps);
            std::vector<std::string> cells{"  " + std::to_string(steps), threeDigits(near.positionMm()),
                                           threeDigits(near.turnDeg()), threeDigits(wide.positionMm()),
                                           threeDigits(wide.turnDeg())};
            for (const double angle : wide.errors.posture)
                cells.push_back(threeDigits(degFromRadians(angle)));
            block.rows.push_back({cells, false});
        }
    }
    return block;
}

std::string errorCsv(const Study& study) {
    std::string csv =
        "target,form,steps,posture_x_deg,posture_y_deg,posture_z_deg,position_x_mm,position_y_mm,"
        "position_z_mm,turn_deg,position_mm\n";
    for (const auto* all : {&study.near, &study.wide})
        for (const StepMeasurement& one : *all) {
            std::vector<std::string> cells{all == &study.near ? "near" : "wide",
                                           std::string(toWord(one.form)), std::to_string(one.steps)};
            for (const double angle : one.errors.posture)
                cells.push_back(formatNumber(degFromRadians(angle)));
            for (const double shift : one.errors.position)
                cells.push_back(formatNumber(mmFromMetres(shift)));
            cells.push_back(formatNumber(one.turnDeg()));
            cells.push_back(formatNumber(one.positionMm()));
            csv += csvLine(cells);
        }
    return csv;
}

Plot errorPlot(const Study& study, const QString& title, const QString& unit,
               double (StepMeasurement::*value)() const) {
    Plot plot;
    plot.title = title;
    plot.xLabel = QStringLiteral("steps");
    plot.yLabel = QStringLiteral("log₁₀ error (%1)").arg(unit);
    plot.x = {0.9, 4.6};
    plot.xMarks = decadeMarks(1, 4);
    for (const StepForm form : kStepForms) {
        Plot::Series series = seriesOf(form);
        series.name.clear();
        for (const StepMeasurement& one : study.wide)
            if (one.form == form && (one.*value)() > kFloorMm)
                series.points.emplace_back(std::log10(one.steps), std::log10((one.*value)()));
        plot.series.push_back(series);
    }
    plot.y = rangeOf(plot.series, 0.08);
    return plot;
}

Picture errorPicture(const Study& study) {
    Picture picture;
    picture.title = QStringLiteral("Error over the number of steps");
    picture.columns = 2;
    picture.panel = QSizeF(520.0, 360.0);
    for (const StepForm form : kStepForms)
        picture.legend.push_back(seriesOf(form));
    picture.plots = {
        errorPlot(study, QStringLiteral("(b) posture"), QStringLiteral("deg"), &StepMeasurement::turnDeg),
        errorPlot(study, QStringLiteral("(c) position"), QStringLiteral("mm"), &StepMeasurement::positionMm)};
    return picture;
}

std::vector<Check> checksOf(const Study& study) {
    std::vector<Check> checks;
    for (const OrderRange& range : kOrders)
        checks.push_back({"order of the " + std::string(toWord(range.form)) + " form", range.order,
                          orderBetween(find(study.wide, range.form, range.coarse),
                                       find(study.wide, range.form, range.fine)),
                          kOrderAllowed});
    const Eigen::Vector3d published =
        find(study.near, StepForm::Open, kPublishedSteps).errors.position.cwiseAbs();
    checks.push_back({"open, 4500 steps, mean error of an axis (um)", kPublishedMicrometres,
                      1e6 * published.mean(), kPublishedPart * kPublishedMicrometres});
    return checks;
}

void addTimes(Exhibit& exhibit, const Study& study) {
    Block block;
    block.header = {"seconds"};
    exhibit.timesCsv = "form,steps,seconds,us_per_step\n";
    for (const StepForm form : kStepForms)
        block.header.push_back(std::string(toWord(form)));
    for (const int steps : kSteps) {
        std::vector<std::string> cells{std::to_string(steps) + " steps"};
        for (const StepForm form : kStepForms)
            cells.push_back(threeDigits(find(study.wide, form, steps).seconds));
        block.rows.push_back({cells, false});
    }
    Plot plot;
    plot.title = QStringLiteral("(a) time");
    plot.xLabel = QStringLiteral("steps");
    plot.yLabel = QStringLiteral("log₁₀ time (s)");
    plot.x = {0.9, 4.6};
    plot.xMarks = decadeMarks(1, 4);
    for (const StepForm form : kStepForms) {
        plot.series.push_back(seriesOf(form));
        for (const StepMeasurement& one : study.wide) {
            if (one.form != form)
                continue;
            plot.series.back().points.emplace_back(std::log10(one.steps), std::log10(one.seconds));
            exhibit.timesCsv +=
                csvLine({std::string(toWord(form)), std::to_string(one.steps), formatNumber(one.seconds),
                         formatNumber(1e6 * one.seconds / one.steps)});
        }
    }
    plot.y = rangeOf(plot.series, 0.08);
    Picture picture;
    picture.title = QStringLiteral("Time over the number of steps");
    picture.plots = {plot};
    exhibit.times = {block};
    exhibit.timesPicture = picture;
    exhibit.aboutTimes =
        "Times of one path: the paper names about " + formatNumber(kPublishedSeconds) +
        " s for 4500 steps in MATLAB, ours are compiled code on one core of this machine. For "
        "comparison only: they are not checked, and differ from run to run.";
}

} // namespace
} // namespace figure13

Exhibit makeFigure13(Experiment& experiment, const Progress& progress) {
    using namespace figure13;
    const Study study = measure(atJointCentre(experiment.platform()), progress);
    Exhibit exhibit;
    exhibit.name = "figure13";
    exhibit.title = "Figure 13 (second paper): error over the number of steps of finite-step integration";
    exhibit.what = "The 6-UPS laboratory platform, output in the middle of its platform joints, along "
                   "straight leg paths from "
                   "home. Near target: 12 -4 40 mm, 0 0 5 deg; wide target: 30 -20 35 mm, 20 -15 25 deg. The "
                   "paper draws its "
                   "target at random and prints none. Open is the paper's form; closed asks also for what "
                   "the constraints "
                   "miss, at the same cost; corrected adds one Newton correction a step.";
    exhibit.blocks = {errorBlock(study)};
    exhibit.notes = {
        "The paper calls the decrease exponential. It is a power of the number of steps: the error of "
        "the open form falls as 1/n, of the closed as 1/n^2, of the corrected as 1/n^4, until "
        "rounding."};
    exhibit.checkRule = "orders within 0.1; the paper's 0.2 um at 4500 steps within 25 %";
    exhibit.checks = checksOf(study);
    exhibit.csv = errorCsv(study);
    exhibit.picture = errorPicture(study);
    addTimes(exhibit, study);
    return exhibit;
}

} // namespace hexapose::reproduce
