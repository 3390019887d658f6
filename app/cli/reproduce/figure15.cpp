// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/exhibits.h"
#include "app/cli/reproduce/experiment.h"
#include "app/cli/reproduce/finite_step_study.h"
#include "app/cli/reproduce/particle_swarm.h"
#include "app/cli/reproduce/printed.h"
#include "app/cli/reproduce/styles.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/kinematics/inverse_kinematics.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace hexapose::reproduce {

namespace figure15 {
namespace {

constexpr std::array<double, 3> kAskedMm{1e-1, 1e-3, 1e-6};
constexpr std::array<int, 11> kSteps{10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000};
constexpr int kMostSteps = 100000;
constexpr int kSeeds = 40;
constexpr double kFoundMm = 1e-3;
constexpr double kFloorMm = 1e-10;
const SwarmOptions kTight{60, 600, 0.05, radiansFromDeg(45.0), 1};
const SwarmOptions kWide{60, 600, 0.1, std::numbers::pi, 1};

/// One search: its error after each iteration, and how long it took.
struct Search {
    std::vector<double> mm, deg;
    double seconds = 0.0;
    bool fits = false; ///< the legs do
};

Search search(const PlatformGeometry& platform, SwarmOptions options, std::uint64_t seed) {
    options.seed = seed;
    const LegLengths lengths = legLengths(platform, wideTarget());
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<Pose> trace = searchPose(platform, lengths, options);
    Search result;
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (const Pose& pose : trace) {
        const PoseErrors errors = errorsBetween(platform, pose, wideTarget());
        result.mm.push_back(mmFromMetres(errors.position.norm()));
        result.deg.push_back(degFromRadians(errors.turn));
    }
    result.fits = mmFromMetres(swarmFitness(platform, lengths, trace.back())) < kFoundMm;
    return result;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct Study {
    std::vector<StepMeasurement> steps;
    std::array<std::array<int, 3>, 3> needed{}; ///< [form][asked]
    std::vector<Search> tight, wide;
    std::vector<double> swarmMm, swarmDeg; ///< medians over the seeds, by iteration
    double swarmSeconds = 0.0;             ///< median, of one iteration

    static int found(const std::vector<Search>& all) {
        return static_cast<int>(std::count_if(all.begin(), all.end(),
                                              [](const Search& one) { return one.mm.back() < kFoundMm; }));
    }
    static int fitting(const std::vector<Search>& all) {
        return static_cast<int>(
            std::count_if(all.begin(), all.end(), [](const Search& one) { return one.fits; }));
    }
};

void summarise(Study& study) {
    for (std::size_t i = 0; i < study.tight.front().mm.size(); ++i) {
        std::vector<double> mm, deg;
        for (const Search& one : study.tight) {
            mm.push_back(one.mm[i]);
            deg.push_back(one.deg[i]);
        }
        study.swarmMm.push_back(median(mm));
        study.swarmDeg.push_back(median(deg));
    }
    std::vector<double> seconds;
    for (const Search& one : study.tight)
        seconds.push_back(one.seconds / kTight.iterations);
    study.swarmSeconds = median(seconds);
}

Study measure(const PlatformGeometry& platform, const Progress& progress) {
    Study study;
    for (std::size_t f = 0; f < kStepForms.size(); ++f) {
        progress(0.1 * static_cast<double>(f));
        for (const int steps : kSteps)
            study.steps.push_back(measureSteps(platform, wideTarget(), kStepForms[f], steps));
        for (std::size_t i = 0; i < kAskedMm.size(); ++i)
            study.needed[f][i] = stepsTo(platform, wideTarget(), kStepForms[f], kAskedMm[i], kMostSteps);
    }
    for (int seed = 1; seed <= kSeeds; ++seed) {
        progress(0.3 + 0.69 * seed / kSeeds);
        study.tight.push_back(search(platform, kTight, static_cast<std::uint64_t>(seed)));
        study.wide.push_back(search(platform, kWide, static_cast<std::uint64_t>(seed)));
    }
    summarise(study);
    return study;
}

/// First iteration from which the median error is at most this; -1 for none.
int iterationsTo(const Study& study, double mm) {
    const auto found =
        std::find_if(study.swarmMm.begin(), study.swarmMm.end(), [mm](double error) { return error <= mm; });
    return found == study.swarmMm.end() ? -1 : static_cast<int>(found - study.swarmMm.begin());
}

std::string countText(int count) {
    return count > 0 ? std::to_string(count) : "not reached";
}

Block neededBlock(const Study& study) {
    Block block;
    block.header = {"to a position error of (mm)"};
    for (const double mm : kAskedMm)
        block.header.push_back(threeDigits(mm));
    for (std::size_t f = 0; f < kStepForms.size(); ++f) {
        std::vector<std::string> cells{"steps, " + std::string(toWord(kStepForms[f]))};
        for (const int steps : study.needed[f])
            cells.push_back(countText(steps));
        block.rows.push_back({cells, false});
    }
    std::vector<std::string> cells{"swarm iterations, median"};
    for (const double mm : kAskedMm)
        cells.push_back(countText(iterationsTo(study, mm)));
    block.rows.push_back({cells, false});
    return block;
}

Block seedBlock(const Study& study) {
    Block block;
    block.header = {"swarm, of " + std::to_string(kSeeds) + " seeds", "legs fit", "right assembly mode"};
    const auto add = [&](const char* name, const std::vector<Search>& all) {
        block.rows.push_back(
            {{name, std::to_string(Study::fitting(all)), std::to_string(Study::found(all))}, false});
    };
    add("tight: +-50 mm, +-45 deg", study.tight);
    add("wide: +-100 mm, +-180 deg", study.wide);
    return block;
}

/// Calls visit(name, work, mm, deg, seconds) for each point; work in evaluations of six legs.
template <class Visit>
void eachPoint(const Study& study, const Visit& visit) {
    for (const StepMeasurement& one : study.steps) {
        const int work = one.steps * (one.form == StepForm::Corrected ? 2 : 1);
        visit(std::string(toWord(one.form)), work, one.positionMm(), one.turnDeg(), one.seconds);
    }
    for (std::size_t i = 0; i < study.swarmMm.size(); i += 10)
        visit(std::string("swarm"), static_cast<int>(i + 1) * kTight.particles, study.swarmMm[i],
              study.swarmDeg[i], static_cast<double>(i + 1) * study.swarmSeconds);
}

Plot curves(const Study& study, const QString& title, const QString& unit, bool posture, bool overTime) {
    Plot plot;
    plot.title = title;
    plot.xLabel = overTime ? QStringLiteral("time (s)") : QStringLiteral("evaluations of six legs");
    plot.yLabel = QStringLiteral("log₁₀ error (%1)").arg(unit);
    plot.x = overTime ? AxisRange{-6.2, 0.2} : AxisRange{0.9, 4.9};
    plot.xMarks = overTime ? decadeMarks(-6, 0) : decadeMarks(1, 4);
    for (const StepForm form : kStepForms)
        plot.series.push_back(seriesOf(form));
    plot.series.push_back(
        {QStringLiteral("particle swarm, median of %1").arg(kSeeds), kBlack, Plot::Marker::Cross, true, {}});
    eachPoint(study, [&](const std::string& name, int work, double mm, double deg, double seconds) {
        const double error = posture ? deg : mm;
        const auto form = stepFormFromWord(name);
        auto& points = plot.series[form ? static_cast<std::size_t>(*form) : kStepForms.size()].points;
        if (error > kFloorMm)
            points.emplace_back(std::log10(overTime ? seconds : work), std::log10(error));
    });
    plot.y = rangeOf(plot.series, 0.08);
    return plot;
}

Picture curvePicture(const Study& study, bool overTime) {
    Picture picture;
    picture.title = overTime ? QStringLiteral("Error over time") : QStringLiteral("Error over the work done");
    picture.columns = 2;
    picture.panel = QSizeF(520.0, 360.0);
    picture.plots = {curves(study, QStringLiteral("(a) posture"), QStringLiteral("deg"), true, overTime),
                     curves(study, QStringLiteral("(b) position"), QStringLiteral("mm"), false, overTime)};
    picture.legend = picture.plots.front().series;
    for (Plot& plot : picture.plots)
        for (Plot::Series& series : plot.series)
            series.name.clear();
    return picture;
}

void addTimes(Exhibit& exhibit, const Study& study) {
    Block block;
    block.header = {"seconds to a position error of (mm)"};
    for (const double mm : kAskedMm)
        block.header.push_back(threeDigits(mm));
    for (std::size_t f = 0; f < kStepForms.size(); ++f) {
        // Time is linear in the steps: that of the longest path tells the rest.
        double perStep = 0.0;
        for (const StepMeasurement& one : study.steps)
            if (one.form == kStepForms[f])
                perStep = one.seconds / one.steps;
        std::vector<std::string> cells{std::string(toWord(kStepForms[f]))};
        for (const int steps : study.needed[f])
            cells.push_back(steps > 0 ? threeDigits(steps * perStep) : "not reached");
        block.rows.push_back({cells, false});
    }
    std::vector<std::string> cells{"swarm, median"};
    for (const double mm : kAskedMm) {
        const int iterations = iterationsTo(study, mm);
        cells.push_back(iterations < 0 ? "not reached" : threeDigits((iterations + 1) * study.swarmSeconds));
    }
    block.rows.push_back({cells, false});
    exhibit.times = {block};
    exhibit.timesCsv = "method,evaluations,seconds,position_mm,turn_deg\n";
    eachPoint(study, [&](const std::string& name, int work, double mm, double deg, double seconds) {
        exhibit.timesCsv +=
            csvLine({name, std::to_string(work), formatNumber(seconds), formatNumber(mm), formatNumber(deg)});
    });
    exhibit.timesPicture = curvePicture(study, true);
    exhibit.aboutTimes =
        "Times on one core of this machine, both methods compiled code (the paper's are MATLAB). For "
        "comparison only: they are not checked, and differ from run to run.";
}

} // namespace
} // namespace figure15

Exhibit makeFigure15(Experiment& experiment, const Progress& progress) {
    using namespace figure15;
    const Study study = measure(atJointCentre(experiment.platform()), progress);
    Exhibit exhibit;
    exhibit.name = "figure15";
    exhibit.title = "Figure 15 (second paper): finite-step integration and particle swarm";
    exhibit.what =
        "Error over work, to 30 -20 35 mm, 20 -15 25 deg. The swarm has 60 particles and the constriction "
        "factor; its fitness is the root mean square of the differences of the legs, as in the paper. "
        "Curves are medians over the seeds, in the tight box.";
    exhibit.blocks = {neededBlock(study), seedBlock(study)};
    exhibit.notes = {
        "In a tight box about home the swarm comes to any precision; the open form does not, for its error "
        "falls as "
        "1/n. In a wide box many seeds fit the legs with a pose of another assembly mode, which no fitness "
        "of legs "
        "tells apart. What finite-step integration has over a search is that it follows one branch."};
    exhibit.checkRule =
        "every seed finds the target in the tight box; the rest of the table is what came out";
    exhibit.checks = {{"seeds that find the target, tight box", static_cast<double>(kSeeds),
                       static_cast<double>(Study::found(study.tight)), 0.5}};
    exhibit.csv = "method,evaluations,position_mm,turn_deg\n";
    eachPoint(study, [&](const std::string& name, int work, double mm, double deg, double) {
        exhibit.csv += csvLine({name, std::to_string(work), formatNumber(mm), formatNumber(deg)});
    });
    exhibit.picture = curvePicture(study, false);
    addTimes(exhibit, study);
    return exhibit;
}

} // namespace hexapose::reproduce
