// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/cli/solver_choice.h"
#include "app/common/arguments.h"
#include "core/base/input_error.h"
#include "core/base/units.h"
#include "core/record/log_reader.h"
#include "core/report/error_report.h"
#include "ui/report/report_export.h"

#include <cstdio>

namespace hexapose {

namespace {

std::vector<SettledSample> settledSamples(const SessionLog& log) {
    std::vector<SettledSample> samples;
    SettledSampler sampler;
    for (const Snapshot& row : log.rows)
        if (const auto sample = sampler.add(row))
            samples.push_back(*sample);
    if (const auto last = sampler.finish())
        samples.push_back(*last);
    return samples;
}

PlatformGeometry platformOf(const SessionLog& log, const Arguments& arguments) {
    if (log.platform && !arguments.has("platform"))
        return *log.platform;
    const PlatformGeometry platform = arguments.platform();
    const std::string recorded = log.platform ? log.platform->fingerprint() : log.platformFingerprint;
    if (!recorded.empty() && platform.fingerprint() != recorded)
        throw InputError("--platform", platform.name + " has the fingerprint " + platform.fingerprint() +
                                           ", but the recorded platform has " + recorded);
    return platform;
}

} // namespace

Usage reportUsage() {
    return {
        "hexapose-cli report",
        {QStringLiteral("LOG.csv")},
        withSolverOptions({{"out", "DIR", "Directory of report.pdf, errors.csv, errors.png and errors.svg."},
                           {"resolution-mm", "R", "Resolution of the lengths (default: 0.1)."}}),
        {},
        {},
        "Platform name or file, for a log without its TOML file (default: that file's, else laboratory)."};
}

int reportCommand(const Arguments& arguments) {
    const std::string directory = arguments.requiredText("out");
    const double resolution = metresFromMm(arguments.positive("resolution-mm", 0.1));
    const std::string file = arguments.operand(0);
    const SessionLog log = readSessionLog(file);
    const PlatformGeometry platform = platformOf(log, arguments);
    for (const std::string& warning : log.warnings)
        std::fprintf(stderr, "hexapose-cli: %s\n", warning.c_str());
    const std::vector<SettledSample> samples = settledSamples(log);
    if (samples.empty())
        throw InputError(file, "holds no settled attitude (a move, then a second of state enabled)");
    const ChosenSolver chosen = chooseSolver(arguments, platform);
    const ErrorReport report = makeErrorReport(platform, *chosen.solver, samples, resolution);
    for (const std::filesystem::path& written : exportErrorReport(report, directory))
        std::printf("%s\n", written.c_str());
    if (!log.platform && !arguments.has("platform"))
        std::fprintf(stderr,
                     "hexapose-cli: %s: nothing beside it says which platform this was; taken for: %s\n",
                     file.c_str(), platform.name.c_str());
    return report.failed > 0 ? kExitSomeFailed : kExitDone;
}

} // namespace hexapose
