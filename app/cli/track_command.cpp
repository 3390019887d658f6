// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/cli/reproduce/tracking_picture.h"
#include "app/cli/reproduce/tracking_table.h"
#include "app/cli/solver_choice.h"
#include "app/cli/track_drive.h"
#include "app/common/arguments.h"
#include "app/common/directories.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/finite_step/mechanism_file.h"
#include "core/finite_step/motion_tracking.h"
#include "ui/plot/picture_files.h"

#include <cstdio>
#include <filesystem>
#include <string>

namespace hexapose {

namespace {

namespace fs = std::filesystem;

constexpr int kDefaultSteps = 1000;
/// Each step is a row of the table.
constexpr std::int64_t kMostRows = 1000000;

/// The system of --mechanism, or of --platform, or of the 6-UPS file.
StepSystem chooseSystem(const Arguments& arguments) {
    if (arguments.has("mechanism") && arguments.has("platform"))
        throw InputError("--mechanism", "cannot be given beside --platform");
    if (arguments.has("platform")) {
        const PlatformGeometry platform = arguments.platform();
        return {mechanismOf(platform), platform.name};
    }
    const fs::path file = findMechanismFile(arguments.text("mechanism", "6-ups"));
    return {loadMechanism(file), file.string()};
}

TrackRates chooseRates(const Arguments& arguments) {
    const std::string word = arguments.text("rates", "equations");
    if (word != "equations" && word != "averages")
        throw InputError("--rates", "'" + word + "' is neither equations nor averages");
    return word == "averages" ? TrackRates::Averages : TrackRates::Equations;
}

std::string stopText(const StepSystem& system, const Track& track, int steps) {
    const TrackRow& last = track.rows.back();
    std::string text = "singular: stopped at step " + std::to_string(track.rows.size() - 1) + " of " +
                       std::to_string(steps) + ", " + formatNumber(last.time) + " s, q " +
                       formatFixed(last.q, 4) + ", smallest singular value " +
                       formatFixed(track.smallestSingularValue, 4) + ", pose";
    const reproduce::TrackVectors values = reproduce::trackValues(system, last.computed);
    for (const std::size_t i : {3U, 0U})
        for (const double value : values[i])
            text += " " + formatFixed(value, 3);
    return text + " (mm, deg)";
}

} // namespace

Usage trackUsage() {
    return {
        "hexapose-cli track",
        {},
        {{"drive", "FILE.csv|reference",
          "What the actuators do: a table over time_s, or the mechanism's own."},
         {"steps", "N", "Steps (default: 1000)."},
         {"out", "DIR", "Directory of tracking.csv, tracking.png and tracking.svg."},
         {"mechanism", "NAME|FILE", "Mechanism: 6-ups (default), 3-ups-s, 6-pus, 6-rus, 3-rps, or a file."},
         {"form", "open|closed|corrected", "Form of a step (default: closed)."},
         {"rates", "equations|averages",
          "Velocity and acceleration from the equations (default), or from averages of steps."}},
        {},
        {},
        "Platform name or file that is itself the mechanism (default: that of --mechanism)."};
}

int trackCommand(const Arguments& arguments) {
    const std::string drive = arguments.requiredText("drive");
    const fs::path directory = arguments.requiredText("out");
    TrackOptions options;
    options.steps = static_cast<int>(arguments.integer("steps", kDefaultSteps, 1, kMostRows));
    options.form = stepForm(arguments, options.form);
    options.rates = chooseRates(arguments);
    const StepSystem system = chooseSystem(arguments);
    const auto path =
        drive == "reference" ? referenceDrive(system.mechanism()) : readDrive(drive, system.mechanism());
    const Track track = trackMotion(system, *path, options);

    makeDirectory(directory);
    writeWholeFile(directory / "tracking.csv", QByteArray::fromStdString(reproduce::trackCsv(system, track)));
    savePicture(reproduce::trackingPicture(system, track), directory / "tracking");
    const std::string summary = reproduce::trackSummary(track);
    std::fwrite(summary.data(), 1, summary.size(), stdout);
    if (!track.isSingular)
        return kExitDone;
    std::fprintf(stderr, "hexapose-cli: track: %s\n", stopText(system, track, options.steps).c_str());
    return kExitSomeFailed;
}

} // namespace hexapose
