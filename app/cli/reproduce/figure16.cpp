// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/exhibits.h"
#include "app/cli/reproduce/experiment.h"
#include "app/cli/reproduce/finite_step_study.h"
#include "app/cli/reproduce/printed.h"
#include "app/cli/reproduce/tracking_picture.h"
#include "app/cli/reproduce/tracking_table.h"
#include "core/base/units.h"

#include <array>
#include <cmath>
#include <utility>

namespace hexapose::reproduce {

namespace figure16 {
namespace {

/// Our drive: legs about home, each with an amplitude and a rate of its own. That of the paper's figure is
/// not in numbers.
constexpr std::array<double, 6> kAmplitudesMm{36.0, 48.0, 44.0, -24.0, 28.0, -16.0};
constexpr std::array<double, 6> kRatesDeg{90.0, 108.0, 81.0, 99.0, 72.0, 117.0};
constexpr double kSeconds = 2.0;
constexpr std::array<int, 3> kSteps{100, 1000, 10000};
constexpr int kDrawn = 1000; ///< steps of the picture and the table
constexpr double kOrderAllowed = 0.1;

struct Method {
    const char* name;
    TrackOptions options;
    double order; ///< of pose and velocity
};
constexpr std::array<Method, 3> kMethods{
    {{"open, averages of steps (the paper)", {0, StepForm::Open, TrackRates::Averages}, 1.0},
     {"closed, equations", {0, StepForm::Closed, TrackRates::Equations}, 2.0},
     {"corrected, equations", {0, StepForm::Corrected, TrackRates::Equations}, 4.0}}};

StepSystem drivenPlatform(const PlatformGeometry& platform) {
    Mechanism mechanism = mechanismOf(atJointCentre(platform));
    for (std::size_t i = 0; i < mechanism.actuators.size(); ++i) {
        mechanism.actuators[i].referenceAmplitude = metresFromMm(kAmplitudesMm[i]);
        mechanism.actuators[i].referenceRate = radiansFromDeg(kRatesDeg[i]);
    }
    return {mechanism, platform.name};
}

Track trackOf(const StepSystem& system, const Method& method, int steps) {
    TrackOptions options = method.options;
    options.steps = steps;
    return trackMotion(system, ReferenceDrive(system.mechanism(), kSeconds), options);
}

using Largest = std::array<double, 6>;

Block errorBlock(const std::vector<std::vector<Largest>>& errors) {
    Block block;
    // In the order of kTrackQuantities; columns are counted in bytes, so there is no raised 2.
    block.header = {"largest error", "posture (deg)",   "ang. vel. (deg/s)", "ang. acc. (deg/s2)",
                    "position (mm)", "velocity (mm/s)", "accel. (mm/s2)"};
    for (std::size_t method = 0; method < kMethods.size(); ++method) {
        block.rows.push_back({{kMethods[method].name}, true});
        for (std::size_t i = 0; i < kSteps.size(); ++i) {
            std::vector<std::string> cells{"  " + std::to_string(kSteps[i]) + " steps"};
            for (const double error : errors[method][i])
                cells.push_back(threeDigits(error));
            block.rows.push_back({cells, false});
        }
    }
    return block;
}

std::vector<Check> checksOf(const std::vector<std::vector<Largest>>& errors) {
    std::vector<Check> checks;
    for (std::size_t method = 0; method < 2; ++method) // the corrected form meets rounding
        for (const std::size_t quantity : {3U, 4U, 5U})
            checks.push_back({std::string("order, ") + kTrackQuantities[quantity].title + ", " +
                                  std::string(toWord(kMethods[method].options.form)),
                              kMethods[method].order,
                              std::log10(errors[method][0][quantity] / errors[method][1][quantity]),
                              kOrderAllowed});
    return checks;
}

} // namespace
} // namespace figure16

Exhibit makeFigure16(Experiment& experiment, const Progress& progress) {
    using namespace figure16;
    const StepSystem system = drivenPlatform(experiment.platform());
    std::vector<std::vector<Largest>> errors(kMethods.size());
    Track published;
    for (std::size_t method = 0; method < kMethods.size(); ++method)
        for (const int steps : kSteps) {
            progress(static_cast<double>(method) / static_cast<double>(kMethods.size()));
            Track track = trackOf(system, kMethods[method], steps);
            errors[method].push_back(largestErrors(track));
            if (method == 0 && steps == kDrawn)
                published = std::move(track);
        }
    Exhibit exhibit;
    exhibit.name = "figure16";
    exhibit.title = "Figure 16 (second paper): motion tracking";
    exhibit.what =
        "The 6-UPS laboratory platform over two seconds, legs about home with amplitudes of 36 48 44 -24 28 "
        "-16 mm and rates of 90 108 81 99 72 117 deg/s. Errors are against Newton's iteration at each step "
        "and the exact derivatives there, in place of the paper's multibody program. The picture and the "
        "CSV are the paper's form, 1000 steps.";
    exhibit.blocks = {errorBlock(errors)};
    exhibit.notes = {"The paper takes velocity and acceleration from averages over steps. The velocity given "
                     "at the beginning "
                     "is no such average: a difference from it would be wrong by half the acceleration or "
                     "more, however many "
                     "steps, so the first acceleration is taken between the first two steps. From the "
                     "derivatives of the step "
                     "equations both come as exact as the pose."};
    exhibit.checkRule = "the error falls by the order of the form, within 0.1";
    exhibit.checks = checksOf(errors);
    exhibit.csv = trackCsv(system, published);
    exhibit.picture = trackingPicture(system, published);
    return exhibit;
}

} // namespace hexapose::reproduce
