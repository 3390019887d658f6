// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/cli/experiment/closed_loop_exhibit.h"
#include "app/cli/experiment/closed_loop_trial.h"
#include "app/cli/reproduce/exhibit_files.h"
#include "app/cli/reproduce/exhibit_text.h"
#include "app/cli/reproduce/reproduction_pdf.h"
#include "app/cli/solver_choice.h"
#include "app/common/arguments.h"
#include "app/common/directories.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "ui/plot/picture_files.h"

#include <cstdio>
#include <filesystem>
#include <string>

namespace hexapose {

namespace {

constexpr int kMostMoves = 1000;

/// "50,70,90,110,130,150", or one number for all legs, in ms.
std::array<double, kLegCount> timeConstants(const Arguments& arguments,
                                            std::array<double, kLegCount> fallback) {
    if (!arguments.has("time-constants-ms"))
        return fallback;
    const std::string text = arguments.requiredText("time-constants-ms");
    const QStringList words = QString::fromStdString(text).split(QLatin1Char(','));
    if (words.size() != 1 && words.size() != kLegCount)
        throw InputError("--time-constants-ms", "'" + text + "' is not one number or six");
    std::array<double, kLegCount> constants{};
    for (int leg = 0; leg < kLegCount; ++leg) {
        const std::string word = words[words.size() == 1 ? 0 : leg].trimmed().toStdString();
        const std::optional<double> ms = parseNumber(word);
        if (!ms || !(*ms > 0.0) || !(*ms <= 10000.0))
            throw InputError("--time-constants-ms", "'" + word + "' is not a number above 0 and up to 10000");
        constants[static_cast<std::size_t>(leg)] = 1e-3 * *ms;
    }
    return constants;
}

experiment::TrialSettings settingsOf(const Arguments& arguments) {
    experiment::TrialSettings settings;
    settings.platform = arguments.platform();
    settings.moves = static_cast<int>(arguments.integer("moves", settings.moves, 1, kMostMoves));
    settings.seed = static_cast<std::uint64_t>(arguments.integer("seed", 1, 0, 1LL << 62));
    settings.legs.timeConstants = timeConstants(arguments, settings.legs.timeConstants);
    settings.legs.speedLimit =
        metresFromMm(arguments.positive("leg-limit-mm-s", mmFromMetres(settings.legs.speedLimit)));
    settings.legs.resolution =
        metresFromMm(arguments.positive("resolution-mm", mmFromMetres(settings.legs.resolution)));
    if (arguments.has("noise-mm"))
        settings.legs.noise = metresFromMm(arguments.requiredPositive("noise-mm"));
    if (arguments.has("no-push"))
        settings.push = 0.0;
    else
        settings.push = metresFromMm(arguments.positive("push-mm", mmFromMetres(settings.push)));
    settings.pushSeconds = arguments.positive("push-s", settings.pushSeconds);
    return settings;
}

} // namespace

Usage experimentUsage() {
    return {"hexapose-cli experiment",
            {QStringLiteral("closed-loop")},
            withSolverOptions(
                {{"out", "DIR", "Directory of the text, CSV, pictures and PDF."},
                 {"moves", "N", "Moves of each mode (default: 20)."},
                 {"seed", "S", "Seed of the random targets (default: 1)."},
                 {"push-mm", "P", "Push of one leg during each move (default: 2)."},
                 {"push-s", "T", "Seconds that a push lasts (default: 0.6)."},
                 {"no-push", "", "Push no leg."},
                 {"time-constants-ms", "T|T1,...,T6",
                  "Time constants of the legs (default: 50,70,90,110,130,150)."},
                 {"leg-limit-mm-s", "V", "Largest speed of the legs (default: 100)."},
                 {"resolution-mm", "R", "Resolution of the reported lengths (default: 0.1)."},
                 {"noise-mm", "N", "Standard deviation of the reported lengths (default: none)."}})};
}

int experimentCommand(const Arguments& arguments) {
    if (arguments.operand(0) != "closed-loop")
        throw InputError("experiment",
                         "unknown experiment '" + arguments.operand(0) + "' (known: closed-loop)");
    const std::filesystem::path directory = arguments.requiredText("out");
    const experiment::TrialSettings settings = settingsOf(arguments);
    const ChosenSolver chosen = chooseSolver(arguments, settings.platform);
    makeDirectory(directory);

    const std::vector<Pose> targets = experiment::drawTargets(settings);
    experiment::TrialSettings calm = settings;
    calm.push = 0.0;
    double done = 0.0;
    const auto runBoth = [&](const experiment::TrialSettings& each) {
        const auto run = [&](MotionMode mode) {
            auto outcomes = experiment::runTrial(each, *chosen.solver, targets, mode, [&](double part) {
                showProgress("moving", done + 0.25 * part);
            });
            done += 0.25;
            return outcomes;
        };
        experiment::BothModes both;
        both.joint = run(MotionMode::Joint);
        both.workspace = run(MotionMode::Workspace);
        return both;
    };
    const experiment::BothModes pushed = runBoth(settings);
    const reproduce::Exhibit exhibit = experiment::closedLoopExhibit(settings, pushed, runBoth(calm));
    reproduce::writeExhibit(exhibit, directory);
    writeWholeFile(directory / "closed-loop.pdf",
                   reproduce::exhibitsPdf({&exhibit, 1}, {QString::fromStdString(exhibit.title),
                                                          QString::fromStdString(exhibit.title)}));
    const std::string text = reproduce::exhibitText(exhibit);
    std::fwrite(text.data(), 1, text.size(), stdout);
    bool fell = false;
    for (const reproduce::Check& check : exhibit.checks) {
        if (check.holds())
            continue;
        fell = true;
        std::fprintf(stderr, "hexapose-cli: closed-loop: %s\n", check.text().c_str());
    }
    return fell ? kExitSomeFailed : kExitDone;
}

} // namespace hexapose
